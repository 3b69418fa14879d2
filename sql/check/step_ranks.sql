-- Step ranks: how many steps of a channel are no longer than each length that occurs.
-- Reads:  step_counts
-- A row:  one length of step of one channel.
SELECT
  channel_id,
  step,
  CAST(
    SUM(occurrences) OVER (
      PARTITION BY channel_id ORDER BY step ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS BIGINT
  ) AS steps_up_to,
  CAST(SUM(occurrences) OVER (PARTITION BY channel_id) AS BIGINT) AS steps_in_all
FROM step_counts
WHERE step > 0
