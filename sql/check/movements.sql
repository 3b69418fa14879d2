-- Movements: how the value of each channel moves from sample to sample, and its range.
-- Reads:  step_counts
-- A row:  one channel; lowest and highest are NULL where every sample is missing. repeats counts samples that have the
--         instant of the one before, where it was taken on trust that none has.
SELECT
  counted.channel_id AS channel_id,
  CAST(SUM(counted.occurrences) AS BIGINT) AS samples,
  CAST(SUM(CASE WHEN counted.step = 0 THEN counted.occurrences ELSE 0 END) AS BIGINT) - 1 AS repeats,
  CAST(SUM(counted.missing) AS BIGINT) AS missing,
  CAST(SUM(counted.rises) AS BIGINT) AS rises,
  CAST(SUM(counted.falls) AS BIGINT) AS falls,
  CAST(SUM(counted.stills) AS BIGINT) AS stills,
  MIN(counted.lowest) AS lowest,
  MAX(counted.highest) AS highest,
  MAX(counted.last_time) AS last_time,
  MAX(counted.sample_end) AS sample_end
FROM step_counts AS counted
GROUP BY counted.channel_id
