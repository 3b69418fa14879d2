-- Run-up: from where on a channel is read so that the first scored vector finds its oldest sample,
-- (m-1) tau samples before. What lies further back cannot matter to any scored vector.
-- Reads:  channels, bounds, samples
-- A row:  one channel with a range, all that coding must know of it; complete = 1 if no sample is missing.
-- Slots:  :span  (m-1) * tau, the samples between oldest and newest
SELECT
  scale.channel_id AS channel_id,
  scale.calibrated_lo AS lo,
  scale.calibrated_hi AS hi,
  CASE WHEN earlier.hit = 1 THEN earlier.run_from ELSE scale.first_scored END AS read_from,
  CASE WHEN earlier.hit = 1 THEN earlier.context_rows ELSE 0 END AS context_rows,
  CASE WHEN named.missing_readings = 0 THEN 1 ELSE 0 END AS complete
FROM bounds AS scale
JOIN channels AS named ON named.channel_id = scale.channel_id
LEFT JOIN (
  SELECT
    channel_id,
    MIN(time) AS run_from,
    CAST(COUNT(*) AS BIGINT) AS context_rows,
    1 AS hit
  FROM (
    SELECT
      sampled.channel_id AS channel_id,
      sampled.time AS time,
      CAST(
        ROW_NUMBER() OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time DESC) AS BIGINT
      ) AS steps_back
    FROM samples AS sampled
    JOIN bounds AS edge ON edge.channel_id = sampled.channel_id
    WHERE sampled.time < edge.first_scored
  ) AS backward
  WHERE steps_back <= :span
  GROUP BY channel_id
) AS earlier ON earlier.channel_id = scale.channel_id
WHERE scale.calibrated_lo IS NOT NULL
