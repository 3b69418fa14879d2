-- Open judgements: the stored judgements that belong to an episode, of those that are looked at again. The number is cast
-- since LAG gives 0, and not NULL, before the first row of a column that ClickHouse keeps as NOT NULL.
-- Reads:  followed, stored_visible_judgement
-- A row:  one judgement.
-- Slots:  :near  a condition on bucket that holds for all of them
SELECT
  part.channel_id AS channel_id,
  0 AS limit_no,
  CAST(bucket.judgement_no AS BIGINT) AS judgement_no,
  bucket.is_open AS is_open,
  bucket.last_zero AS last_zero
FROM stored_visible_judgement AS bucket
JOIN followed AS part ON part.version_id = bucket.version_id
WHERE bucket.is_open = 1 AND bucket.judgement_no >= part.since_judgement AND :near
