-- Opened: is a judgement open? Its last up is later than its last down: evidence at the height in a raised window, and
-- three windows in a row that are not raised (alarms, section 4).
-- Reads:  evidence
-- A row:  one judgement under one limit; last_zero is the latest one without evidence, NULL if there was none.
SELECT
  channel_id,
  limit_no,
  judgement_no,
  root,
  reference,
  height,
  evidence,
  CASE WHEN last_up > last_down OR (last_up >= 0 AND last_down IS NULL) THEN 1 ELSE 0 END AS is_open,
  last_zero
FROM (
  SELECT
    channel_id,
    limit_no,
    judgement_no,
    root,
    reference,
    height,
    evidence,
    MAX(CASE WHEN evidence >= height AND root > reference THEN judgement_no END) OVER (
      PARTITION BY channel_id, limit_no
      ORDER BY judgement_no
      ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS last_up,
    MAX(
      CASE WHEN root <= reference AND root_before <= reference AND root_earlier <= reference
        THEN judgement_no END
    ) OVER (
      PARTITION BY channel_id, limit_no
      ORDER BY judgement_no
      ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS last_down,
    MAX(CASE WHEN evidence = 0 THEN judgement_no END) OVER (
      PARTITION BY channel_id, limit_no
      ORDER BY judgement_no
      ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS last_zero
  FROM (
    SELECT
      channel_id,
      limit_no,
      judgement_no,
      root,
      reference,
      height,
      evidence,
      LAG(root, 1) OVER (PARTITION BY channel_id, limit_no ORDER BY judgement_no) AS root_before,
      LAG(root, 2) OVER (PARTITION BY channel_id, limit_no ORDER BY judgement_no) AS root_earlier
    FROM evidence
  ) AS lagged
) AS known
