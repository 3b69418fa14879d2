-- No sums: of channels whose still_after is on, codes do not say all that was read. There are none.
-- Reads:  cohort
SELECT
  channel_id,
  CAST(0 AS BIGINT) AS summed_from,
  CAST(0 AS BIGINT) AS read_sum
FROM cohort
WHERE 1 = 0
