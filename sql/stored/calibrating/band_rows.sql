-- Band rows: where calibration of a new version was, by the newest coordinate.
-- Reads:  bands, numbering
-- A row:  one band of a new version that calibration visited, for one width.
SELECT
  numbered.version_id AS version_id,
  part.g AS g,
  part.band AS band,
  part.visits AS visits,
  part.novel_buffered AS novel_buffered
FROM bands AS part
JOIN numbering AS numbered ON numbered.channel_id = part.channel_id
