-- Unjudged programs: what machines run since calibration that it holds too little of, or nothing. Its readings are not
-- judged; they are after a full refresh with a calibration that holds it.
-- Reads:  judged_samples, channels
-- A row:  one program of one channel; program is NULL where nothing says what ran.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  sampled.program AS program,
  CAST(COUNT(*) AS BIGINT) AS readings
FROM judged_samples AS sampled
JOIN channels AS named ON named.channel_id = sampled.channel_id
WHERE sampled.program_no IS NULL AND sampled.value IS NOT NULL AND sampled.time >= named.first_scored
GROUP BY named.asset, named.channel, sampled.program
