-- Evidence: how far the roots have stood above the reference, summed since it was least within 50 judgements
-- (alarms, section 4). One judgement adds half a height at most, so that none opens an episode alone.
-- Reads:  rooted
-- A row:  one judgement under one limit; what is summed begins anew with each judged_from: the first judgement that a
--         limit is for.
SELECT
  channel_id,
  limit_no,
  judged_from,
  judgement_no,
  root,
  reference,
  height,
  prior_open,
  prior_zero,
  risen - CASE WHEN judgement_no - first_near <= 49 AND least_risen > 0 THEN 0 ELSE least_risen END
    AS evidence
FROM (
  SELECT
    channel_id,
    limit_no,
    judged_from,
    judgement_no,
    root,
    reference,
    height,
    prior_open,
    prior_zero,
    risen,
    MIN(judgement_no) OVER (
      PARTITION BY channel_id, limit_no, judged_from
      ORDER BY judgement_no
      ROWS BETWEEN 50 PRECEDING AND CURRENT ROW
    ) AS first_near,
    MIN(risen) OVER (
      PARTITION BY channel_id, limit_no, judged_from
      ORDER BY judgement_no
      ROWS BETWEEN 50 PRECEDING AND CURRENT ROW
    ) AS least_risen
  FROM (
    SELECT
      channel_id,
      limit_no,
      judged_from,
      judgement_no,
      root,
      reference,
      height,
      prior_open,
      prior_zero,
      CAST(
        SUM(CASE WHEN root - reference > cap THEN cap ELSE root - reference END) OVER (
          PARTITION BY channel_id, limit_no, judged_from
          ORDER BY judgement_no
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS risen
    FROM rooted
  ) AS summed
) AS reached
