-- Rejudged windows: the judgements that there must be: of each full window of buckets, and those whose buckets were
-- pruned.
-- Reads:  kept_judgements, rejudged_buckets, judged_windows
-- A row:  one judgement of a version that has any; its figures before known_until are taken as they are.
-- Slots:  :buckets  W / stride, the buckets of a window
SELECT
  made.channel_id AS channel_id,
  made.judgement_no AS judgement_no,
  made.last_bucket AS bucket_no,
  closing.run_id AS run_id,
  made.first_time AS first_time,
  made.last_time AS last_time,
  made.novel AS novel
FROM judged_windows AS made
JOIN rejudged_buckets AS closing
  ON closing.channel_id = made.channel_id AND closing.bucket_no = made.last_bucket
JOIN (
  SELECT DISTINCT channel_id
  FROM kept_judgements
) AS watched ON watched.channel_id = made.channel_id
UNION ALL
SELECT DISTINCT
  kept.channel_id AS channel_id,
  kept.judgement_no AS judgement_no,
  (kept.judgement_no + 1) * :buckets - 1 AS bucket_no,
  kept.run_id AS run_id,
  kept.first_time AS first_time,
  kept.last_time AS last_time,
  kept.novel AS novel
FROM kept_judgements AS kept
LEFT JOIN (
  SELECT channel_id, MIN(bucket_no) AS first_bucket, 1 AS hit
  FROM rejudged_buckets
  GROUP BY channel_id
) AS oldest ON oldest.channel_id = kept.channel_id
WHERE CASE
  WHEN oldest.hit = 1 AND kept.judgement_no * :buckets >= oldest.first_bucket THEN 0
  WHEN kept.first_time > kept.last_time THEN 0
  ELSE 1
END = 1
