-- Cycles: the length of a channel's cycle, the shortest period about as strong as the strongest; its
-- multiples are as strong, and a vibration within a longer cycle can hide it.
-- Reads:  peaks
-- A row:  one channel that has a cycle.
SELECT
  ranked.channel_id AS channel_id,
  MIN(CASE WHEN ranked.strength >= ranked.strongest - CAST(1e-1 AS DOUBLE) THEN ranked.period END)
    AS cycle_length,
  MAX(ranked.strongest) AS cycle_strength
FROM (
  SELECT
    channel_id,
    period,
    strength,
    MAX(strength) OVER (PARTITION BY channel_id) AS strongest
  FROM peaks
) AS ranked
GROUP BY ranked.channel_id
