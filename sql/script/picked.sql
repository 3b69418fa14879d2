-- Picked: about a thousand vectors of calibration, by which a channel is probed.
-- Reads:  learnt
-- Slots:  :picked  whether a vector is picked
SELECT asset, channel, time, block, number
FROM (
  SELECT asset, channel, time, block, place AS number, vectors
  FROM learnt
) AS numbered
WHERE :picked
