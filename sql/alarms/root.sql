-- Root: the square root of a count, in thousandths: its noise is half a root whatever the count (alarms, section 2).
-- Slots:  :count
CAST(FLOOR(SQRT(CAST(1000000 * :count + 375000 AS DOUBLE))) AS BIGINT)
