-- Growth: how many states of the signals that are shown are known by then; all of them at once, since the view
-- counts each time over all signals.
-- Reads:  stored_growth
-- A row:  one block of calibration, or one full bucket; times are integers.
-- Slots:  :monitor  its name
--         :chosen   which assets and channels are wanted
SELECT asset, channel, phase, number, last_tick, healthy, novel
FROM stored_growth
WHERE monitor = :monitor AND :chosen
ORDER BY asset, channel, last_tick, number
