-- Grafana ranked: what is known of each machine that is chosen now, the one to be looked at first being first.
-- Reads:  stored_machine
-- A row:  one machine.
-- Slots:  :monitor  its name
--         :assets   the machines that are chosen
SELECT asset, since_time, above, watched, first_channel, strongest_channel, strength, not_watched, data_time
FROM stored_machine
WHERE monitor = :monitor AND asset IN (:assets)
ORDER BY machine_rank
