-- Drawn: every part under every drawing of assets. Drawing 0 takes each asset once; the others are
-- bootstrap samples, in which an asset stands as often as it was drawn.
-- Reads:  parts, drawings
-- A row:  one part of one series under one drawing.
SELECT
  drawing.drawing AS group_id,
  part.part AS part,
  part.part_value AS part_value,
  drawing.weight AS weight
FROM parts AS part
JOIN drawings AS drawing
  ON drawing.asset_no = part.asset_no AND drawing.stratum = part.stratum
