-- Evidence: how far the roots have stood above the reference, summed since it was least within 50 judgements
-- (alarms, section 4). One judgement adds half a height at most, so that none opens an episode alone.
-- Reads:  rooted
-- A row:  one judgement under one limit.
SELECT
  channel_id,
  limit_no,
  judgement_no,
  root,
  reference,
  height,
  risen - CASE WHEN judgement_no <= 49 AND least_risen > 0 THEN 0 ELSE least_risen END AS evidence
FROM (
  SELECT
    channel_id,
    limit_no,
    judgement_no,
    root,
    reference,
    height,
    risen,
    MIN(risen) OVER (
      PARTITION BY channel_id, limit_no
      ORDER BY judgement_no
      ROWS BETWEEN 50 PRECEDING AND CURRENT ROW
    ) AS least_risen
  FROM (
    SELECT
      channel_id,
      limit_no,
      judgement_no,
      root,
      reference,
      height,
      CAST(
        SUM(CASE WHEN root - reference > cap THEN cap ELSE root - reference END) OVER (
          PARTITION BY channel_id, limit_no
          ORDER BY judgement_no
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS risen
    FROM rooted
  ) AS summed
) AS reached
