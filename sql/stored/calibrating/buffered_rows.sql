-- Buffered rows: of each block of calibration the vectors in cells that only blocks near it visited.
-- Reads:  buffered, numbering
-- A row:  one block of a new version, for one width.
SELECT
  numbered.version_id AS version_id,
  part.block AS block,
  part.g AS g,
  part.vectors AS vectors,
  part.novel_buffered AS novel_buffered
FROM buffered AS part
JOIN numbering AS numbered ON numbered.channel_id = part.channel_id
