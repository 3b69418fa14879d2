-- Found episodes: what the judgements that are looked at again raise, as alarms/merged.sql finds it.
-- Reads:  merged, followed, stored_visible_judgement, stored_limit
-- A row:  one episode; onset_time is NULL where the judgement of its onset was pruned.
-- Slots:  :near  a condition on bucket that holds for all judgements of these episodes, from their onset
SELECT
  part.channel_id AS channel_id,
  part.version_id AS version_id,
  found.onset AS onset,
  found.first_judgement AS first_judgement,
  found.last_judgement AS last_judgement,
  MIN(CASE WHEN bucket.judgement_no = found.onset THEN bucket.first_time END) AS onset_time,
  MIN(CASE WHEN bucket.judgement_no = found.first_judgement THEN bucket.first_time END) AS first_time,
  MAX(bucket.last_time) AS last_time,
  MAX(bucket.evidence) AS evidence,
  MAX(CASE WHEN bucket.judgement_no = found.first_judgement THEN bucket.height END) AS height,
  MAX(CASE WHEN found.first_judgement < learnt.blocks THEN 1 ELSE 0 END) AS is_proving
FROM merged AS found
JOIN followed AS part ON part.channel_id = found.channel_id
JOIN stored_visible_judgement AS bucket
  ON bucket.version_id = part.version_id
  AND bucket.judgement_no >= found.onset
  AND bucket.judgement_no <= found.last_judgement
JOIN (
  SELECT version_id, MAX(CASE WHEN made.reason IS NULL THEN made.blocks ELSE 0 END) AS blocks
  FROM stored_limit AS made
  GROUP BY version_id
) AS learnt ON learnt.version_id = part.version_id
WHERE :near
GROUP BY
  part.channel_id,
  part.version_id,
  found.onset,
  found.first_judgement,
  found.last_judgement
