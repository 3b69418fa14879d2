-- Raised again: the episodes that there must be, as alarms/merged.sql finds them.
-- Reads:  merged, judged_again, judged_edges, judged_until, stored_limit
-- A row:  one episode of one version; onset_time is NULL where the judgement of its onset was pruned. is_open = 1 if it
--         goes on.
SELECT
  part.version_id AS version_id,
  found.onset AS onset,
  found.first_judgement AS first_judgement,
  found.last_judgement AS last_judgement,
  MIN(CASE WHEN made.judgement_no = found.onset THEN made.first_time END) AS onset_time,
  MIN(CASE WHEN made.judgement_no = found.first_judgement THEN made.first_time END) AS first_time,
  MAX(made.last_time) AS last_time,
  MAX(made.evidence) AS evidence,
  MAX(CASE WHEN made.judgement_no = found.first_judgement THEN made.height END) AS height,
  MAX(CASE WHEN found.first_judgement < learnt.blocks THEN 1 ELSE 0 END) AS is_proving,
  MAX(CASE WHEN found.last_judgement = ending.newest_no THEN learnt.is_judged ELSE 0 END) AS is_open
FROM merged AS found
JOIN judged_until AS part ON part.channel_id = found.channel_id
JOIN judged_again AS made
  ON made.channel_id = found.channel_id
  AND made.judgement_no >= found.onset
  AND made.judgement_no <= found.last_judgement
JOIN judged_edges AS ending ON ending.channel_id = found.channel_id
JOIN (
  SELECT
    each_limit.version_id AS version_id,
    MAX(each_limit.blocks) AS blocks,
    MAX(CASE WHEN each_limit.limit_no = newest.newest_no AND each_limit.reason IS NULL THEN 1 ELSE 0 END)
      AS is_judged
  FROM stored_limit AS each_limit
  JOIN (
    SELECT version_id, MAX(limit_no) AS newest_no
    FROM stored_limit
    GROUP BY version_id
  ) AS newest ON newest.version_id = each_limit.version_id
  GROUP BY each_limit.version_id
) AS learnt ON learnt.version_id = part.version_id
GROUP BY
  part.version_id,
  found.onset,
  found.first_judgement,
  found.last_judgement
