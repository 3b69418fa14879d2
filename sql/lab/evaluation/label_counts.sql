-- Label counts: how many labelled events hold a value, how many of these were raised, and the lead of the
-- middle one (of two, the shorter).
-- Reads:  label_leads
-- A row:  one channel; with channel NULL one machine; with asset NULL as well all machines.
SELECT
  asset,
  channel,
  CAST(SUM(has_values) AS BIGINT) AS labels,
  CAST(COUNT(event_lead) AS BIGINT) AS labels_raised,
  MIN(CASE WHEN 2 * lead_no BETWEEN leads AND leads + 1 THEN event_lead END) AS lead_time
FROM (
  SELECT
    asset,
    channel,
    has_values,
    lead_time AS event_lead,
    CAST(COUNT(lead_time) OVER (PARTITION BY asset, channel) AS BIGINT) AS leads,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY asset, channel ORDER BY CASE WHEN lead_time IS NULL THEN 1 ELSE 0 END, lead_time
      ) AS BIGINT
    ) AS lead_no
  FROM (
    SELECT asset, channel, has_values, lead_time FROM label_leads
    UNION ALL
    SELECT
      CAST(NULL AS VARCHAR) AS asset,
      CAST(NULL AS VARCHAR) AS channel,
      of_machine.has_values AS has_values,
      of_machine.lead_time AS lead_time
    FROM label_leads AS of_machine
    WHERE of_machine.channel IS NULL
  ) AS of_all
) AS numbered
GROUP BY asset, channel
