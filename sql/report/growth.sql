-- Growth: how many states of one signal are known by then.
-- Reads:  stored_growth
-- A row:  one block of calibration, or one full bucket; times are integers.
-- Slots:  :monitor, :asset, :channel  the signal
SELECT phase, number, last_tick, healthy, novel
FROM stored_growth
WHERE monitor = :monitor AND asset = :asset AND channel = :channel
ORDER BY last_tick, number
