-- New cells: the states that one signal has visited since, and never in calibration.
-- Reads:  stored_quarantine
-- A row:  one cell; times are integers.
-- Slots:  :monitor, :asset, :channel  the signal
SELECT cell_key, visits, first_tick AS first_time, last_tick AS last_time
FROM stored_quarantine
WHERE monitor = :monitor AND asset = :asset AND channel = :channel
ORDER BY visits DESC, cell_key
