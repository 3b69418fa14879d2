-- Opened: is a judgement open? Its last up is later than its last down: evidence at the height in a raised window, and
-- three windows in a row that are not raised (alarms, section 4). A judgement that is known already stands for all
-- before it.
-- Reads:  evidence
-- A row:  one judgement under one limit; last_zero is the latest one that an onset cannot lie before: one without
--         evidence, an open one before this one, or the one before a limit began to count. NULL if there was none. A
--         height of 1 is that of the indicator, under which evidence is 0 in a window that is not raised.
SELECT
  channel_id,
  limit_no,
  judgement_no,
  root,
  reference,
  height,
  evidence,
  is_open,
  CASE
    WHEN zero IS NULL OR opened_before > zero THEN opened_before
    ELSE zero
  END AS last_zero
FROM (
  SELECT
    channel_id,
    limit_no,
    judgement_no,
    root,
    reference,
    height,
    evidence,
    is_open,
    zero,
    MAX(CASE WHEN is_open = 1 THEN judgement_no END) OVER (
      PARTITION BY channel_id, limit_no
      ORDER BY judgement_no
      ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING
    ) AS opened_before
  FROM (
    SELECT
      channel_id,
      limit_no,
      judgement_no,
      root,
      reference,
      height,
      evidence,
      CASE WHEN last_up > last_down OR (last_up >= 0 AND last_down IS NULL) THEN 1 ELSE 0 END AS is_open,
      zero
    FROM (
      SELECT
        channel_id,
        limit_no,
        judgement_no,
        root,
        reference,
        height,
        evidence,
        MAX(
          CASE
            WHEN prior_open = 1 THEN judgement_no
            WHEN prior_open < 0 AND evidence >= height AND is_raised = 1 THEN judgement_no
          END
        ) OVER (
          PARTITION BY channel_id, limit_no
          ORDER BY judgement_no
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS last_up,
        MAX(
          CASE
            WHEN prior_open = 0 THEN judgement_no
            WHEN prior_open < 0 AND is_raised = 0 AND was_raised = 0 AND was_raised_before = 0
              THEN judgement_no
          END
        ) OVER (
          PARTITION BY channel_id, limit_no
          ORDER BY judgement_no
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS last_down,
        MAX(
          CASE
            WHEN prior_open >= 0 THEN prior_zero
            WHEN evidence = 0 OR (height = 1 AND is_raised = 0) THEN judgement_no
            WHEN judged_from > 0 THEN judged_from - 1
          END
        ) OVER (
          PARTITION BY channel_id, limit_no
          ORDER BY judgement_no
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS zero
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
          evidence,
          is_raised,
          LAG(is_raised, 1) OVER (PARTITION BY channel_id, limit_no ORDER BY judgement_no) AS was_raised,
          LAG(is_raised, 2) OVER (PARTITION BY channel_id, limit_no ORDER BY judgement_no)
            AS was_raised_before
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
            evidence,
            CASE WHEN root > reference THEN 1 ELSE 0 END AS is_raised
          FROM evidence
        ) AS compared
      ) AS lagged
    ) AS turns
  ) AS states
) AS openings
