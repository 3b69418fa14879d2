-- Detection: F1, false-alarm rate and missed-alarm rate of the values, and what becomes of the labels.
-- F1 = 2 hits / (raised + labelled); false-alarm rate = raised values that are not labelled, of all that
-- are not labelled; missed-alarm rate = labelled values that are not raised, of all labelled ones.
-- Chance raises as many values at a random place in time: F1 is then 2 raised labelled / counted over
-- raised + labelled in the mean over all places.
-- Reads:  detection_counts, label_counts
-- A row:  one channel; with channel NULL one machine; with asset NULL as well all machines. In order.
SELECT
  counts.asset AS asset,
  counts.channel AS channel,
  counts.counted AS counted,
  counts.left_out AS left_out,
  counts.raised AS raised,
  counts.labelled AS labelled,
  counts.hits AS hits,
  CAST(2 * counts.hits AS DOUBLE) / CAST(NULLIF(counts.raised + counts.labelled, 0) AS DOUBLE) AS f1,
  CAST(2 AS DOUBLE) * CAST(counts.raised AS DOUBLE) * CAST(counts.labelled AS DOUBLE)
  / (
    CAST(NULLIF(counts.counted, 0) AS DOUBLE)
    * CAST(NULLIF(counts.raised + counts.labelled, 0) AS DOUBLE)
  ) AS f1_chance,
  CAST(counts.raised - counts.hits AS DOUBLE)
  / CAST(NULLIF(counts.counted - counts.labelled, 0) AS DOUBLE) AS false_alarm_rate,
  CAST(counts.labelled - counts.hits AS DOUBLE)
  / CAST(NULLIF(counts.labelled, 0) AS DOUBLE) AS missed_alarm_rate,
  COALESCE(events.labels, 0) AS labels,
  COALESCE(events.labels_raised, 0) AS labels_raised,
  events.lead AS lead
FROM detection_counts AS counts
LEFT JOIN label_counts AS events
  ON COALESCE(events.asset, '') = COALESCE(counts.asset, '')
    AND (events.asset IS NULL) = (counts.asset IS NULL)
    AND COALESCE(events.channel, '') = COALESCE(counts.channel, '')
    AND (events.channel IS NULL) = (counts.channel IS NULL)
ORDER BY
  CASE WHEN counts.asset IS NULL THEN 1 ELSE 0 END,
  counts.asset,
  CASE WHEN counts.channel IS NULL THEN 0 ELSE 1 END,
  counts.channel
