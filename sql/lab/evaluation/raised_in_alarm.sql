-- Raised in alarm: each value of the indicator, and whether its time lies in an alarm of its channel.
-- The alarms that have begun less those that have ended are counted along time.
-- Reads:  indicator, alarms
-- A row:  one value.
SELECT asset, channel, time, CASE WHEN alarms_on > 0 THEN 1 ELSE 0 END AS is_raised
FROM (
  SELECT
    asset,
    channel,
    time,
    moment,
    SUM(change) OVER (
      PARTITION BY asset, channel ORDER BY time, moment ROWS UNBOUNDED PRECEDING
    ) AS alarms_on
  FROM (
    SELECT asset, channel, time, 1 AS moment, 0 AS change
    FROM indicator
    WHERE hi IS NOT NULL
    UNION ALL
    SELECT named.asset AS asset, named.channel AS channel, alarm.starts_at AS time, 0 AS moment, 1 AS change
    FROM alarms AS alarm
    JOIN (SELECT DISTINCT asset, channel FROM indicator) AS named
      ON named.asset = alarm.asset AND COALESCE(alarm.channel, named.channel) = named.channel
    UNION ALL
    SELECT named.asset AS asset, named.channel AS channel, alarm.ends_at AS time, 2 AS moment, -1 AS change
    FROM alarms AS alarm
    JOIN (SELECT DISTINCT asset, channel FROM indicator) AS named
      ON named.asset = alarm.asset AND COALESCE(alarm.channel, named.channel) = named.channel
  ) AS moments
) AS counted
WHERE moment = 1
