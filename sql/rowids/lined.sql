-- Lined: all readings, one after another by name and time: the only time that they are sorted. For SQLite, which
-- sorts for every grouping too: what lies in order is counted where it lies. Proof: none is needed; it sorts.
-- Dialect: sqlite
-- Reads:  readings, spoken
-- A row:  one reading. What is not a number between -1e300 and 1e300 is missing.
SELECT
  spoken.rowid AS name_no,
  reading.time AS time,
  CASE
    WHEN reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN reading.reading
  END AS value
FROM readings AS reading
JOIN spoken
  ON spoken.asset IS NOT DISTINCT FROM reading.asset
  AND spoken.channel IS NOT DISTINCT FROM reading.channel
ORDER BY name_no, time
