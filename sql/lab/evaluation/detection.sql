-- Detection: F1, false-alarm rate and missed-alarm rate of the values, and what becomes of the labels.
-- F1 = 2 hits / (raised + labelled); false-alarm rate = raised values that are not labelled, of all that
-- are not labelled; missed-alarm rate = labelled values that are not raised, of all labelled ones.
-- Chance raises as many values at a random place in time: F1 is then 2 raised labelled / counted over
-- raised + labelled in the mean over all places.
-- Reads:  detection_counts, label_counts
-- A row:  one channel; with channel NULL one machine; with asset NULL as well all machines. In order.
SELECT
  asset,
  channel,
  counted,
  left_out,
  raised,
  labelled,
  hits,
  CAST(2 * hits AS DOUBLE) / CAST(NULLIF(raised + labelled, 0) AS DOUBLE) AS f1,
  CAST(2 AS DOUBLE) * CAST(raised AS DOUBLE) * CAST(labelled AS DOUBLE)
  / (CAST(NULLIF(counted, 0) AS DOUBLE) * CAST(NULLIF(raised + labelled, 0) AS DOUBLE)) AS f1_chance,
  CAST(raised - hits AS DOUBLE) / CAST(NULLIF(counted - labelled, 0) AS DOUBLE) AS false_alarm_rate,
  CAST(labelled - hits AS DOUBLE) / CAST(NULLIF(labelled, 0) AS DOUBLE) AS missed_alarm_rate,
  labels,
  labels_raised,
  lead_time
FROM (
  SELECT
    asset,
    channel,
    CAST(SUM(part.counted) AS BIGINT) AS counted,
    CAST(SUM(part.left_out) AS BIGINT) AS left_out,
    CAST(SUM(part.raised) AS BIGINT) AS raised,
    CAST(SUM(part.labelled) AS BIGINT) AS labelled,
    CAST(SUM(part.hits) AS BIGINT) AS hits,
    CAST(SUM(part.labels) AS BIGINT) AS labels,
    CAST(SUM(part.labels_raised) AS BIGINT) AS labels_raised,
    MAX(part.lead_time) AS lead_time
  FROM (
    SELECT
      asset,
      channel,
      counted,
      left_out,
      raised,
      labelled,
      hits,
      0 AS labels,
      0 AS labels_raised,
      CAST(NULL AS BIGINT) AS lead_time
    FROM detection_counts
    UNION ALL
    SELECT
      asset,
      channel,
      0 AS counted,
      0 AS left_out,
      0 AS raised,
      0 AS labelled,
      0 AS hits,
      labels,
      labels_raised,
      lead_time
    FROM label_counts
  ) AS part
  GROUP BY asset, channel
) AS figures
ORDER BY
  CASE WHEN asset IS NULL THEN 1 ELSE 0 END,
  asset,
  CASE WHEN channel IS NULL THEN 0 ELSE 1 END,
  channel
