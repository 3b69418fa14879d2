-- Seen, straight from the source, slice by slice of time: what a run reads of channels of which it is taken that no
-- instant occurs twice; as stored/scoring/seen.sql and census/slices.sql. For DuckDB, whose source is read as it is
-- stored and not copied first. Proof: the vectors have no mark, and the rows are as many when they are counted again.
-- Reads:  readings, cohort
-- A row:  one channel in one slice that has a row of it in its range.
-- Slots:  :origin  the earliest time of all
--         :width   of a slice, in the unit of time
SELECT
  channel_id,
  asset,
  channel,
  slice_no,
  CAST(COUNT(*) AS BIGINT) AS readings,
  CAST(SUM(cut.before_scored) AS BIGINT) AS context_rows,
  CAST(COUNT(*) AS BIGINT) - CAST(SUM(cut.is_there) AS BIGINT) AS missing_samples,
  MIN(cut.time) AS earliest,
  MAX(cut.time) AS latest
FROM (
  SELECT
    member.channel_id AS channel_id,
    member.asset AS asset,
    member.channel AS channel,
    reading.time AS time,
    CASE WHEN reading.time < member.first_scored THEN 1 ELSE 0 END AS before_scored,
    CASE
      WHEN reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN 1
      ELSE 0
    END AS is_there,
    CAST(
      FLOOR((CAST(reading.time - :origin AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(:width AS DOUBLE))
      AS INTEGER
    ) AS slice_no
  FROM readings AS reading
  JOIN cohort AS member ON member.asset = reading.asset AND member.channel = reading.channel
  WHERE reading.time BETWEEN member.read_from AND member.read_until
) AS cut
GROUP BY channel_id, asset, channel, slice_no
