-- Timeline: the values of each channel and machine in time, with the labels that hold at each, and the
-- starts of labels among them.
-- Reads:  raised_machines, labels
-- A row:  one value (moment 1), or one start of a label (moment 0).
--         labels_on, margins_on  labels whose interval, or interval with its margins, holds it
--         raised_since           where the newest run of raised values starts, up to here
--         calm_at                the newest value that is not raised, up to here
--         raised_next            where the next run of raised values starts, from here on
--         value_next             the next value, from here on
SELECT
  asset,
  channel,
  time,
  moment,
  label_no,
  ends_at,
  is_raised,
  SUM(label_change) OVER (
    PARTITION BY asset, channel ORDER BY time, moment ROWS UNBOUNDED PRECEDING
  ) AS labels_on,
  SUM(margin_change) OVER (
    PARTITION BY asset, channel ORDER BY time, moment ROWS UNBOUNDED PRECEDING
  ) AS margins_on,
  MAX(run_start) OVER (
    PARTITION BY asset, channel ORDER BY time, moment ROWS UNBOUNDED PRECEDING
  ) AS raised_since,
  MAX(CASE WHEN is_raised = 0 THEN time END) OVER (
    PARTITION BY asset, channel ORDER BY time, moment ROWS UNBOUNDED PRECEDING
  ) AS calm_at,
  MIN(run_start) OVER (
    PARTITION BY asset, channel ORDER BY time DESC, moment DESC ROWS UNBOUNDED PRECEDING
  ) AS raised_next,
  MIN(CASE WHEN moment = 1 THEN time END) OVER (
    PARTITION BY asset, channel ORDER BY time DESC, moment DESC ROWS UNBOUNDED PRECEDING
  ) AS value_next
FROM (
  SELECT
    asset,
    channel,
    time,
    1 AS moment,
    CAST(NULL AS BIGINT) AS label_no,
    CAST(NULL AS BIGINT) AS ends_at,
    is_raised,
    CASE WHEN is_raised = 1 AND (value_no = 1 OR raised_before = 0) THEN time END AS run_start,
    0 AS label_change,
    0 AS margin_change
  FROM (
    SELECT
      asset,
      channel,
      time,
      is_raised,
      LAG(is_raised, 1) OVER (PARTITION BY asset, channel ORDER BY time) AS raised_before,
      CAST(ROW_NUMBER() OVER (PARTITION BY asset, channel ORDER BY time) AS BIGINT) AS value_no
    FROM raised_machines
  ) AS lagged
  UNION ALL
  SELECT
    named.asset AS asset,
    named.channel AS channel,
    CASE edge.edge_no
      WHEN 1 THEN label.starts_at
      WHEN 2 THEN label.ends_at
      WHEN 3 THEN label.left_out_from
      ELSE label.left_out_until
    END AS time,
    CASE edge.edge_no WHEN 1 THEN 0 WHEN 3 THEN -1 ELSE 2 END AS moment,
    CASE WHEN edge.edge_no = 1 THEN label.label_no END AS label_no,
    label.ends_at AS ends_at,
    CAST(NULL AS BIGINT) AS is_raised,
    CAST(NULL AS BIGINT) AS run_start,
    CASE edge.edge_no WHEN 1 THEN 1 WHEN 2 THEN -1 ELSE 0 END AS label_change,
    CASE edge.edge_no WHEN 3 THEN 1 WHEN 4 THEN -1 ELSE 0 END AS margin_change
  FROM labels AS label
  JOIN (SELECT DISTINCT asset, channel FROM raised_machines) AS named
    ON named.asset = label.asset
      AND (named.channel = label.channel OR named.channel IS NULL OR label.channel IS NULL)
  CROSS JOIN (
    SELECT 1 AS edge_no UNION ALL SELECT 2 AS edge_no UNION ALL SELECT 3 AS edge_no UNION ALL SELECT 4 AS edge_no
  ) AS edge
) AS moments
