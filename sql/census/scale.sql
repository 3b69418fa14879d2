-- Scale: all that must be known of a channel to code its samples, so that readings are joined by name once.
-- Reads:  channels, bounds, run_up, calibration
-- A row:  one channel with a range. taught_from and taught_to are NULL where it has no calibration of its
--         own; complete = 1 if no sample is missing.
SELECT
  named.channel_id AS channel_id,
  named.support_id AS support_id,
  named.asset AS asset,
  named.channel AS channel,
  named.readings AS readings,
  reached.lo AS lo,
  reached.hi AS hi,
  reached.complete AS complete,
  reached.read_from AS read_from,
  reached.context_rows AS context_rows,
  CASE WHEN piece.hit = 1 THEN piece.time_from END AS taught_from,
  CASE WHEN piece.hit = 1 THEN piece.time_to END AS taught_to,
  edge.calibration_samples AS calibration_samples,
  edge.first_scored AS first_scored
FROM run_up AS reached
JOIN bounds AS edge ON edge.channel_id = reached.channel_id
JOIN channels AS named ON named.channel_id = reached.channel_id
LEFT JOIN (
  SELECT channel_id, time_from, time_to, 1 AS hit
  FROM calibration
) AS piece ON piece.channel_id = reached.channel_id
