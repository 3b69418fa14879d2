-- Machines: what is known of each machine of one monitor now.
-- Reads:  stored_machine
-- A row:  one machine, the one to be looked at first being first; times are integers.
-- Slots:  :monitor  its name
SELECT
  asset,
  signals,
  watched,
  not_watched,
  judged,
  above,
  not_judged,
  since_tick,
  first_channel,
  strongest_channel,
  strength,
  together,
  data_tick
FROM stored_machine
WHERE monitor = :monitor
ORDER BY machine_rank
