-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Hour, lengths: how many readings each channel has from an instant on.
-- Slots:  :earliest  microseconds since 1970
SELECT asset, channel, COUNT(*) AS readings
FROM telemetry.readings
WHERE t >= MAKE_TIMESTAMP(CAST(:earliest AS BIGINT))
GROUP BY asset, channel
ORDER BY asset, channel
