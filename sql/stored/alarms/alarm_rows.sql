-- Alarm rows: the episodes of a monitor, for people.
-- Reads:  stored_alarm
-- A row:  one episode, those that need attention first, then by what it is, the newest first; times are integers. sure is
--         NULL where the indicator opened it.
-- Slots:  :monitor  its name
SELECT
  raised.episode_id AS episode,
  raised.asset AS asset,
  raised.channel AS channel,
  raised.told_as AS status,
  raised.needs_attention AS needs_attention,
  raised.since_tick AS since,
  raised.first_tick AS opened,
  raised.last_tick AS last_time,
  CASE WHEN raised.height > 1 THEN CAST(raised.evidence AS DOUBLE) / CAST(raised.height AS DOUBLE) END AS sure,
  raised.basis AS basis,
  raised.stated_rate AS stated_rate,
  raised.asked AS asked,
  raised.signals_open AS signals_open,
  raised.incident_id AS incident,
  raised.signals_together AS signals_together,
  raised.label AS label,
  raised.label_until AS label_until,
  raised.note AS note,
  raised.merged_into AS merged_into,
  raised.onset AS onset,
  raised.first_judgement AS first_judgement,
  raised.last_judgement AS last_judgement,
  raised.evidence AS evidence,
  raised.height AS height,
  raised.seq AS seq,
  raised.channel_id AS channel_id,
  raised.version_id AS version_id
FROM stored_alarm AS raised
WHERE raised.monitor = :monitor
ORDER BY
  raised.needs_attention DESC,
  CASE raised.told_as WHEN 'proving' THEN 0 WHEN 'open' THEN 1 WHEN 'high' THEN 2 ELSE 3 END,
  raised.episode_id DESC
