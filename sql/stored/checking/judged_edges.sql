-- Judged edges: the first and the last of the judgements that there must be.
-- Reads:  judged_again
-- A row:  one version that has any, which is its own channel here.
SELECT
  channel_id,
  MIN(made.judgement_no) AS oldest_no,
  MAX(made.judgement_no) AS newest_no
FROM judged_again AS made
GROUP BY channel_id
