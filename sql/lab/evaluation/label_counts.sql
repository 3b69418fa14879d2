-- Label counts: how many labelled events hold a value, how many of these were raised, and the lead of the
-- middle one (of two, the shorter).
-- Reads:  label_leads
-- A row:  one channel; with channel NULL one machine; with asset NULL as well all machines.
SELECT
  asset,
  channel,
  CAST(SUM(has_values) AS BIGINT) AS labels,
  CAST(COUNT(lead) AS BIGINT) AS labels_raised,
  MIN(CASE WHEN 2 * lead_no BETWEEN leads AND leads + 1 THEN lead END) AS lead
FROM (
  SELECT
    asset,
    channel,
    has_values,
    lead,
    COUNT(lead) OVER (PARTITION BY asset, channel) AS leads,
    ROW_NUMBER() OVER (
      PARTITION BY asset, channel ORDER BY CASE WHEN lead IS NULL THEN 1 ELSE 0 END, lead
    ) AS lead_no
  FROM (
    SELECT asset, channel, has_values, lead FROM label_leads
    UNION ALL
    SELECT NULL AS asset, NULL AS channel, has_values, lead FROM label_leads WHERE channel IS NULL
  ) AS of_all
) AS numbered
GROUP BY asset, channel
