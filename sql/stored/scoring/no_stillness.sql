-- No stillness: of channels whose still_after is off, as in the paper, no sample counts as still. There are none.
-- Reads:  cohort
SELECT
  channel_id,
  CAST(0 AS BIGINT) AS bucket_no,
  CAST(0 AS BIGINT) AS still,
  CAST(0 AS BIGINT) AS still_since
FROM cohort
WHERE 1 = 0
