-- Staying: versions of which rows have left the source.
-- Reads:  active, oldest_rows
-- A row:  one version.
SELECT
  frozen.version_id AS version_id,
  frozen.window_length AS window_length,
  frozen.stride AS stride
FROM active AS frozen
JOIN oldest_rows AS gone ON gone.version_id = frozen.version_id
