-- Slices: what the source holds, by name and slice of time, in one pass that sorts nothing. Where calibration
-- ends, its range and the run-up follow from these few rows and the samples of a slice or two.
-- Reads:  readings
-- A row:  one (asset, channel) pair in one slice; slice_no is NULL for rows without a time.
-- Slots:  :origin  the earliest time of all
--         :width   of a slice, in the unit of time
SELECT
  asset,
  channel,
  slice_no,
  CASE WHEN slice_no IS NULL THEN 0 ELSE CAST(COUNT(*) AS BIGINT) END AS readings,
  CASE WHEN slice_no IS NULL THEN CAST(COUNT(*) AS BIGINT) ELSE 0 END AS without_time,
  CAST(COUNT(*) AS BIGINT) - CAST(COUNT(cut.value) AS BIGINT) AS missing_readings,
  MIN(cut.value) AS lowest,
  MAX(cut.value) AS highest,
  MIN(cut.time) AS earliest,
  MAX(cut.time) AS latest
FROM (
  SELECT
    asset,
    channel,
    time,
    CASE
      WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN reading
    END AS value,
    CAST(
      FLOOR((CAST(time - :origin AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(:width AS DOUBLE)) AS INTEGER
    ) AS slice_no
  FROM readings
) AS cut
GROUP BY asset, channel, slice_no
