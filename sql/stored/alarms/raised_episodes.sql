-- Raised episodes: those that the judgements of this run raise, as alarms/merged.sql has them.
-- Reads:  merged, followed, stored_visible_judgement, stored_limit
-- A row:  one episode; onset_time is NULL where the judgement of its onset was pruned.
-- Slots:  :near  a condition on bucket that holds for all judgements of these episodes, from their onset
SELECT
  part.channel_id AS channel_id,
  part.version_id AS version_id,
  episode.onset AS onset,
  episode.first_judgement AS first_judgement,
  episode.last_judgement AS last_judgement,
  MIN(CASE WHEN bucket.judgement_no = episode.onset THEN bucket.first_time END) AS onset_time,
  MIN(CASE WHEN bucket.judgement_no = episode.first_judgement THEN bucket.first_time END) AS first_time,
  MAX(bucket.last_time) AS last_time,
  MAX(bucket.evidence) AS evidence,
  MAX(CASE WHEN bucket.judgement_no = episode.first_judgement THEN bucket.height END) AS height,
  MAX(CASE WHEN episode.first_judgement < learnt.blocks THEN 1 ELSE 0 END) AS is_proving
FROM merged AS episode
JOIN followed AS part ON part.channel_id = episode.channel_id
JOIN stored_visible_judgement AS bucket
  ON bucket.version_id = part.version_id
  AND bucket.judgement_no >= episode.onset
  AND bucket.judgement_no <= episode.last_judgement
JOIN (
  SELECT version_id, MAX(CASE WHEN limit_row.reason IS NULL THEN limit_row.blocks ELSE 0 END) AS blocks
  FROM stored_limit AS limit_row
  GROUP BY version_id
) AS learnt ON learnt.version_id = part.version_id
WHERE :near
GROUP BY
  part.channel_id,
  part.version_id,
  episode.onset,
  episode.first_judgement,
  episode.last_judgement
