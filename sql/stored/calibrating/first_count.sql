-- First count: what recount gives, without a look at the readings of a channel in which no instant occurs twice:
-- each of its samples is one reading.
-- Reads:  calibrated, timeline, recount (of the other channels)
-- A row:  one channel that has a reading in calibration.
SELECT learnt.channel_id AS channel_id, learnt.calibration_samples AS calibration_readings
FROM calibrated AS learnt
JOIN timeline AS clock ON clock.channel_id = learnt.channel_id
WHERE clock.repeats = 0
UNION ALL
SELECT counted.channel_id AS channel_id, counted.calibration_readings AS calibration_readings
FROM recount AS counted
