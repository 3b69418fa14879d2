-- Inconsistent judgements: what must hold of those that are stored, also where their buckets were pruned: numbers
-- without a gap, times in order, roots of what they count.
-- Reads:  checked, stored_visible_judgement
-- A row:  one version with such; since is the beginning of the first.
-- Slots:  :root  the expression of alarms/root.sql
SELECT version_id, CAST(COUNT(*) AS BIGINT) AS differing, MIN(judged.first_time) AS since
FROM (
  SELECT
    kept.version_id AS version_id,
    kept.first_time AS first_time,
    kept.last_time AS last_time,
    kept.root AS root,
    :root AS root_again,
    kept.judgement_no - MIN(kept.judgement_no) OVER (PARTITION BY kept.version_id) + 1 AS place,
    CAST(ROW_NUMBER() OVER (PARTITION BY kept.version_id ORDER BY kept.judgement_no) AS BIGINT) AS places
  FROM stored_visible_judgement AS kept
  JOIN checked AS version ON version.version_id = kept.version_id
) AS judged
WHERE place <> places OR root <> root_again OR first_time > last_time
GROUP BY version_id
