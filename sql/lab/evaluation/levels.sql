-- Levels: the values of a series as integers from 0, the same up to offset and scale, which no metric
-- of trend depends on.
-- Reads:  ordered
-- A row:  one value.
-- Slots:  :level  the integer
SELECT series_id, value_no, k, hi, hi_before, CAST(:level AS BIGINT) AS level
FROM ordered
