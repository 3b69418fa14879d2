-- Scale: all that must be known of a channel to code its samples, so that readings are joined by name once.
-- Reads:  channels, limits, run_up, edge_samples
-- A row:  one channel with a range. From taught_from to taught_to lie all its samples before it is scored, those of
--         calibration and any others; complete = 1 if every vector counts.
-- Slots:  :complete  1 if no sample is missing, and no segment ends
SELECT
  named.channel_id AS channel_id,
  named.support_id AS support_id,
  named.asset AS asset,
  named.channel AS channel,
  named.readings AS readings,
  reached.lo AS lo,
  reached.hi AS hi,
  :complete AS complete,
  reached.read_from AS read_from,
  reached.context_rows AS context_rows,
  edge.calibration_from AS taught_from,
  edge.first_scored - 1 AS taught_to,
  edge.first_scored AS first_scored,
  CASE WHEN earlier.hit = 1 THEN earlier.samples ELSE 0 END AS samples_before
FROM run_up AS reached
JOIN limits AS edge ON edge.channel_id = reached.channel_id
JOIN channels AS named ON named.channel_id = reached.channel_id
LEFT JOIN (
  SELECT sampled.channel_id AS channel_id, MAX(sampled.place) AS samples, 1 AS hit
  FROM edge_samples AS sampled
  JOIN limits AS edge ON edge.channel_id = sampled.channel_id
  WHERE sampled.time < edge.first_scored
  GROUP BY sampled.channel_id
) AS earlier ON earlier.channel_id = reached.channel_id
