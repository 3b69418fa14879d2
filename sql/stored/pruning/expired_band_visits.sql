-- Expired band visits: rows of judgements that go, or that a later run wrote again.
-- Reads:  pruned_versions, stored_band_visit, staying_judgements
-- A row:  one judgement that a run wrote.
SELECT DISTINCT
  counted.version_id AS version_id,
  counted.judgement_no AS judgement_no,
  counted.run_id AS run_id
FROM stored_band_visit AS counted
JOIN pruned_versions AS pruned ON pruned.version_id = counted.version_id
LEFT JOIN (
  SELECT version_id, judgement_no, run_id, 1 AS hit
  FROM staying_judgements
) AS staying
  ON staying.version_id = counted.version_id
  AND staying.judgement_no = counted.judgement_no
  AND staying.run_id = counted.run_id
WHERE CASE WHEN staying.hit = 1 THEN 0 ELSE 1 END = 1
