-- Cycles: the length of a cycle: on the finest scale whose highest peak reaches one half, the first peak
-- of nine tenths of that height. Coarser scales are smoother, and would prefer multiples.
-- Reads:  peaks
-- A row:  one channel that has such a peak; cycle_length in samples, to within half of a scale.
SELECT channel_id, MIN(delay * scale) AS cycle_length, MAX(highest) AS likeness
FROM (
  SELECT
    channel_id,
    scale,
    delay,
    acf,
    highest,
    CAST(
      DENSE_RANK() OVER (PARTITION BY channel_id ORDER BY scale) AS BIGINT
    ) AS fineness
  FROM (
    SELECT
      channel_id,
      scale,
      delay,
      acf,
      MAX(acf) OVER (PARTITION BY channel_id, scale) AS highest
    FROM peaks
  ) AS compared
  WHERE highest >= CAST(5e-1 AS DOUBLE)
) AS ranked
WHERE fineness = 1 AND acf >= CAST(9e-1 AS DOUBLE) * highest
GROUP BY channel_id
