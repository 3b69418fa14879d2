-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Extract, lengths: the channels and how many readings each has, in the order of extract_readings.
SELECT asset, channel, COUNT(*) AS readings
FROM readings
GROUP BY asset, channel
ORDER BY asset, channel
