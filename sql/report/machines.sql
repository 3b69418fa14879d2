-- Machines: what is known of each machine of one monitor now.
-- Reads:  stored_machine
-- A row:  one machine; times are integers.
-- Slots:  :monitor  its name
SELECT asset, signals, judged, above, not_judged, since_tick, together, data_tick
FROM stored_machine
WHERE monitor = :monitor
