-- Merged: runs of open judgements, those with fewer than 10 judgements between them as one (alarms, section 4).
-- Reads:  opened
-- A row:  one episode of one channel under one limit, numbered from 1. It began where evidence last left 0 before it
--         opened.
SELECT
  channel_id,
  limit_no,
  episode_no,
  MIN(numbered.judgement_no) AS first_judgement,
  MAX(numbered.judgement_no) AS last_judgement,
  MIN(CASE WHEN opens = 1 THEN begins END) AS onset
FROM (
  SELECT
    channel_id,
    limit_no,
    judgement_no,
    begins,
    opens,
    CAST(
      SUM(opens) OVER (
        PARTITION BY channel_id, limit_no
        ORDER BY judgement_no
        ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS episode_no
  FROM (
    SELECT
      channel_id,
      limit_no,
      judgement_no,
      CASE WHEN last_zero IS NULL THEN 0 ELSE last_zero + 1 END AS begins,
      CASE
        WHEN judgement_no - LAG(CASE WHEN judgement_no >= 0 THEN judgement_no END, 1) OVER (
          PARTITION BY channel_id, limit_no ORDER BY judgement_no
        ) <= 10 THEN 0
        ELSE 1
      END AS opens
    FROM opened
    WHERE is_open = 1
  ) AS compared
) AS numbered
GROUP BY channel_id, limit_no, episode_no
