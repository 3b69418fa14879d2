-- Coded, in order: all samples of the channels with a range, coded (Phi, method section 3), one after another, so
-- that the number of a row (rowid) is its place. For SQLite, where a window costs as much as all else: a delay is
-- then a row some numbers before. Proof: rows of CREATE TABLE AS are numbered from 1 in the order of its query.
-- Dialect: sqlite
-- Reads:  readings, scale
-- A row:  one sample, kept. What is not a number between -1e300 and 1e300 is missing.
-- Slots:  :code  the expression of support/code.sql, cast to the narrowest integer that holds it
SELECT channel_id, time, :code AS code
FROM (
  SELECT
    scale.channel_id AS channel_id,
    reading.time AS time,
    CASE
      WHEN reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE)
        THEN reading.reading
    END AS value,
    scale.lo AS lo,
    scale.hi AS hi
  FROM readings AS reading
  JOIN scale ON scale.asset = reading.asset AND scale.channel = reading.channel
  WHERE reading.time IS NOT NULL
) AS ranged
ORDER BY channel_id, time
