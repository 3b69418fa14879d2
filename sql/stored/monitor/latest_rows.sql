-- Latest rows: the newest row that was read of each channel.
-- Reads:  readings, begun
-- A row:  one channel of which there is one.
SELECT part.asset AS asset, part.channel AS channel, MAX(reading.time) AS latest
FROM readings AS reading
JOIN begun AS part ON part.channel_id = reading.channel_id
GROUP BY part.asset, part.channel
