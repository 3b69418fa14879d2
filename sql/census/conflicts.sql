-- Conflicts: at how many instants a channel had two different values, where the readings are collapsed.
-- Reads:  readings, channels
-- A row:  one channel.
SELECT named.channel_id AS channel_id, CAST(SUM(reading.conflict) AS BIGINT) AS conflicts
FROM readings AS reading
JOIN channels AS named ON named.asset = reading.asset AND named.channel = reading.channel
GROUP BY named.channel_id
