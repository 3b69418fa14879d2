-- Fleet summary: each metric of the fleet with its bootstrap interval, between the values that hold
-- :tail of the samples in which it is available on either side.
-- Reads:  metric_values
-- A row:  one metric, in order.
-- Slots:  :tail  share of the samples below the interval, and above it
SELECT
  metric,
  MAX(CASE WHEN drawing = 0 THEN metric_value END) AS value,
  MAX(CASE WHEN drawing = 0 THEN spread END) AS sd,
  CAST(MAX(CASE WHEN drawing = 0 THEN bounded.counted END) AS BIGINT) AS counted,
  MAX(CASE WHEN is_sample = 1 AND place = lower_place THEN metric_value END) AS lower_bound,
  MAX(CASE WHEN is_sample = 1 AND place = upper_place THEN metric_value END) AS upper_bound,
  CAST(MAX(bounded.samples) AS BIGINT) AS samples,
  MAX(CASE WHEN drawing = 0 THEN bounded.reason END) AS reason
FROM (
  SELECT
    metric,
    metric_no,
    drawing,
    metric_value,
    spread,
    counted,
    reason,
    is_sample,
    place,
    samples,
    1 + CAST(FLOOR(CAST(:tail AS DOUBLE) * CAST(samples - 1 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT)
      AS lower_place,
    samples - CAST(FLOOR(CAST(:tail AS DOUBLE) * CAST(samples - 1 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT)
      AS upper_place
  FROM (
    SELECT
      metric,
      metric_no,
      drawing,
      metric_value,
      spread,
      counted,
      reason,
      is_sample,
      CAST(
        ROW_NUMBER() OVER (PARTITION BY metric_no, is_sample ORDER BY metric_value) AS BIGINT
      ) AS place,
      CAST(SUM(is_sample) OVER (PARTITION BY metric_no) AS BIGINT) AS samples
    FROM (
      SELECT
        metric,
        metric_no,
        drawing,
        metric_value,
        spread,
        counted,
        reason,
        CASE WHEN drawing > 0 AND metric_value IS NOT NULL THEN 1 ELSE 0 END AS is_sample
      FROM metric_values
    ) AS flagged
  ) AS sorted_values
) AS bounded
GROUP BY metric_no, metric
ORDER BY metric_no
