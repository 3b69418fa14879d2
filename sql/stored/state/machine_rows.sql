-- Machine rows: what is known of the machines of one monitor now, the one to be looked at first being first.
-- Reads:  stored_machine
-- A row:  one machine; since is integer time.
-- Slots:  :monitor  its name
SELECT
  asset,
  signals AS channels,
  watched,
  not_watched,
  above,
  since_tick AS since,
  first_channel,
  strongest_channel,
  strength,
  together
FROM stored_machine
WHERE monitor = :monitor
ORDER BY machine_rank
