-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Hour, readings: those from an instant on, in order.
-- Slots:  :earliest  microseconds since 1970
SELECT EPOCH_US(t) AS t, value
FROM telemetry.readings
WHERE t >= MAKE_TIMESTAMP(CAST(:earliest AS BIGINT))
ORDER BY asset, channel, t
