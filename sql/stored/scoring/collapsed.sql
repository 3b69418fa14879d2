-- Collapsed, stored form: the readings of a group of channels in which an instant occurs twice: the smallest value of
-- each instant that is not missing (method, section 2). The steps run once more over these.
-- Reads:  identified
-- A row:  one sample.
-- Slots:  :gathered  the least program of an instant, where a column says what a machine runs
SELECT channel_id, time, MIN(reading.value) AS value, :gathered
FROM identified AS reading
GROUP BY channel_id, time
