-- Course: the indicator of every signal of one monitor over time.
-- Reads:  stored_health
-- A row:  one full bucket of an active version, those of a signal beside one another; times are integers.
-- Slots:  :monitor  its name
SELECT asset, channel, bucket, first_tick, last_tick, novel, out_of_range, hi
FROM stored_health
WHERE monitor = :monitor
ORDER BY asset, channel, bucket
