-- Lengths: how long calibration is; from first to last sample where its intervals are nothing but instants
-- (alarms, section 3).
-- Reads:  calibration, declared_lengths, samples
-- A row:  one channel that has calibration.
SELECT
  summed.channel_id AS channel_id,
  CASE WHEN summed.length > 0 THEN summed.length WHEN sampled.hit = 1 THEN sampled.length ELSE 0 END
    AS length
FROM declared_lengths AS summed
LEFT JOIN (
  SELECT inside.channel_id AS channel_id, MAX(inside.time) - MIN(inside.time) AS length, 1 AS hit
  FROM samples AS inside
  JOIN calibration AS piece ON piece.channel_id = inside.channel_id
  WHERE piece.time_from = piece.time_to AND inside.time = piece.time_from
  GROUP BY inside.channel_id
) AS sampled ON sampled.channel_id = summed.channel_id
