-- None resumed: no channel is parked, so none sends again.
-- Reads:  parted
SELECT version_id
FROM parted
WHERE 1 = 0
