-- Open judgements: the stored judgements of a cohort that belong to an episode. The number is cast since LAG gives 0,
-- and not NULL, before the first row of a column that ClickHouse keeps as NOT NULL.
-- Reads:  cohort, stored_visible_judgement
-- A row:  one judgement.
SELECT
  part.channel_id AS channel_id,
  0 AS limit_no,
  CAST(known.judgement_no AS BIGINT) AS judgement_no,
  known.is_open AS is_open,
  known.last_zero AS last_zero
FROM stored_visible_judgement AS known
JOIN cohort AS part ON part.version_id = known.version_id
WHERE known.is_open = 1
