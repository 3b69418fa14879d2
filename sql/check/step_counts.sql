-- Step counts: every length of step in time with how often it occurs, and how the value moved over these
-- steps. A machine that samples regularly has few; all figures of time and movement follow from them.
-- Reads:  ordered_samples
-- A row:  one length of step of one channel; 0 is the first sample, which has no step before it, and each that has the
--         instant of the one before.
-- Slots:  :longest_sample  the samples of a channel that the dear looks are limited to
SELECT
  moved.channel_id AS channel_id,
  moved.step AS step,
  CAST(COUNT(*) AS BIGINT) AS occurrences,
  CAST(SUM(CASE WHEN moved.value > moved.value_before THEN 1 ELSE 0 END) AS BIGINT) AS rises,
  CAST(SUM(CASE WHEN moved.value < moved.value_before THEN 1 ELSE 0 END) AS BIGINT) AS falls,
  CAST(SUM(CASE WHEN moved.value = moved.value_before THEN 1 ELSE 0 END) AS BIGINT) AS stills,
  CAST(SUM(CASE WHEN moved.value IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS missing,
  MIN(moved.value) AS lowest,
  MAX(moved.value) AS highest,
  MAX(moved.time) AS last_time,
  MAX(CASE WHEN moved.position <= :longest_sample THEN moved.time END) AS sample_end
FROM (
  SELECT
    channel_id,
    time,
    value,
    position,
    CASE WHEN position > 1 THEN time - previous_time ELSE 0 END AS step,
    CASE WHEN position > 1 THEN previous_value END AS value_before
  FROM ordered_samples
) AS moved
GROUP BY moved.channel_id, moved.step
