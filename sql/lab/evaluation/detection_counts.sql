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
  SELECT
    asset,
    channel,
    is_raised,
    CASE WHEN labels_on > 0 THEN 1 ELSE 0 END AS is_labelled,
    CASE WHEN labels_on > 0 OR margins_on = 0 THEN 1 ELSE 0 END AS is_counted
  FROM (
    SELECT asset, channel, is_raised, labels_on, margins_on
    FROM timeline
    WHERE moment = 1
    UNION ALL
    SELECT
      CAST(NULL AS VARCHAR) AS asset,
      CAST(NULL AS VARCHAR) AS channel,
      of_machine.is_raised AS is_raised,
      of_machine.labels_on AS labels_on,
      of_machine.margins_on AS margins_on
    FROM timeline AS of_machine
    WHERE of_machine.moment = 1 AND of_machine.channel IS NULL
  ) AS of_all
) AS marked
GROUP BY asset, channel
