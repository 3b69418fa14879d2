-- Samples, dbt form: one value per instant, the smallest; NULL where it is missing (method, section 2).
-- Reads:  identified
-- A row:  one sample.
-- Slots:  :gathered  the least program of an instant, where a column says what a machine runs
SELECT channel_id, time, MIN(reading.value) AS value, :gathered
FROM identified AS reading
GROUP BY channel_id, time
