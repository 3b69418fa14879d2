-- Promises: how many judgements the limits of a monitor made, and how many of them may be false alarms, so many each.
-- Reads:  stored_monitor, stored_channel, stored_version, stored_limit, stored_visible_judgement
-- A row:  one limit of one version that judged something; stated_rate is NULL where no rate can be stated.
-- Slots:  :monitor  its name
SELECT
  named.asset AS asset,
  named.channel AS channel,
  limit_row.asked AS asked,
  limit_row.stated_rate AS stated_rate,
  judged.judgements AS judgements
FROM stored_monitor AS watching
JOIN stored_channel AS named ON named.monitor_id = watching.monitor_id
JOIN stored_version AS version ON version.channel_id = named.channel_id
JOIN (
  SELECT version_id, limit_no, CAST(COUNT(*) AS BIGINT) AS judgements
  FROM (
    SELECT part.version_id AS version_id, part.judgement_no AS judgement_no, MAX(held.limit_no) AS limit_no
    FROM stored_visible_judgement AS part
    JOIN stored_limit AS held
      ON held.version_id = part.version_id AND held.from_judgement <= part.judgement_no
    WHERE held.reason IS NULL
    GROUP BY part.version_id, part.judgement_no
  ) AS each_judgement
  GROUP BY version_id, limit_no
) AS judged ON judged.version_id = version.version_id
JOIN stored_limit AS limit_row ON limit_row.version_id = judged.version_id AND limit_row.limit_no = judged.limit_no
WHERE watching.name = :monitor
ORDER BY named.asset, named.channel, judged.version_id, judged.limit_no
