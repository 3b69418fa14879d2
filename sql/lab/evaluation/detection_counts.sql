-- Detection counts: how many values are raised, labelled, and both. A value in the margin of a label, but
-- in no label, is left out.
-- Reads:  timeline
-- A row:  one channel; with channel NULL one machine; with asset NULL as well all machines.
SELECT
  asset,
  channel,
  CAST(SUM(is_counted) AS BIGINT) AS counted,
  CAST(SUM(1 - is_counted) AS BIGINT) AS left_out,
  CAST(SUM(is_counted * is_raised) AS BIGINT) AS raised,
  CAST(SUM(is_labelled) AS BIGINT) AS labelled,
  CAST(SUM(is_labelled * is_raised) AS BIGINT) AS hits
FROM (
  SELECT asset, channel, is_raised, is_labelled, is_counted FROM (
    SELECT
      asset,
      channel,
      is_raised,
      CASE WHEN labels_on > 0 THEN 1 ELSE 0 END AS is_labelled,
      CASE WHEN labels_on > 0 OR margins_on = 0 THEN 1 ELSE 0 END AS is_counted
    FROM timeline
    WHERE moment = 1
  ) AS of_series
  UNION ALL
  SELECT NULL AS asset, NULL AS channel, is_raised, is_labelled, is_counted FROM (
    SELECT
      is_raised,
      CASE WHEN labels_on > 0 THEN 1 ELSE 0 END AS is_labelled,
      CASE WHEN labels_on > 0 OR margins_on = 0 THEN 1 ELSE 0 END AS is_counted
    FROM timeline
    WHERE moment = 1 AND channel IS NULL
  ) AS of_machines
) AS marked
GROUP BY asset, channel
