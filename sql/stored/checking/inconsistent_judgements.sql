-- Inconsistent judgements: what must hold of those that are stored, also where their buckets were pruned: numbers
-- without a gap, times in order, roots of what they count.
-- Reads:  checked, stored_visible_judgement
-- A row:  one version with such; since is the beginning of the first.
-- Slots:  :root  the expression of alarms/root.sql
SELECT version_id, CAST(COUNT(*) AS BIGINT) AS differing, MIN(judged.first_time) AS since
FROM (
  SELECT
    judgement.version_id AS version_id,
    judgement.first_time AS first_time,
    judgement.last_time AS last_time,
    judgement.root AS root,
    :root AS root_again,
    judgement.judgement_no - MIN(judgement.judgement_no) OVER (PARTITION BY judgement.version_id) + 1 AS place,
    CAST(ROW_NUMBER() OVER (PARTITION BY judgement.version_id ORDER BY judgement.judgement_no) AS BIGINT) AS places
  FROM stored_visible_judgement AS judgement
  JOIN checked AS version ON version.version_id = judgement.version_id
) AS judged
WHERE place <> places OR root <> root_again OR first_time > last_time
GROUP BY version_id
