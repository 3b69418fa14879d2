-- Refined: the slices, where those of a range of time are cut finer: they held too much of what must be read sample
-- by sample, as where nearly all rows lie in one of them.
-- Reads:  slices, finer, the slices of the readings of that range.
-- A row:  one (asset, channel) pair in one slice.
-- Slots:  :first, :last  the range; no slice lies partly in it
SELECT
  asset,
  channel,
  slice_no,
  readings,
  without_time,
  missing_readings,
  lowest,
  highest,
  earliest,
  latest
FROM slices
WHERE slice_no IS NULL OR earliest < :first OR earliest > :last
UNION ALL
SELECT
  asset,
  channel,
  slice_no,
  readings,
  without_time,
  missing_readings,
  lowest,
  highest,
  earliest,
  latest
FROM finer
