-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Extract, readings: all of them in order. The names need not travel: the lengths say where each
-- channel begins.
SELECT t, value
FROM readings
ORDER BY asset, channel, t
