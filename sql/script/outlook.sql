-- Outlook: how many vectors calibration needs in all, by a power law through half and all of its blocks.
-- Reads:  floors, learning
-- Slots:  :least_vectors  the fewest vectors of calibration
--         :target_floor   the largest floor of a channel that is ready
SELECT
  known.asset AS asset,
  known.channel AS channel,
  known.vectors AS vectors,
  CASE
    WHEN ahead.hit = 1 AND ahead.needed_total > CAST(:least_vectors AS DOUBLE) THEN ahead.needed_total
    WHEN known.vectors < :least_vectors THEN CAST(:least_vectors AS DOUBLE)
    WHEN ahead.hit = 1 THEN ahead.needed_total
  END AS needed_total
FROM floors AS known
LEFT JOIN (
  SELECT
    asset,
    channel,
    CASE
      WHEN descent <= exponent * LN(CAST(1000 AS DOUBLE))
        THEN CAST(vectors AS DOUBLE) * EXP(descent / NULLIF(exponent, CAST(0 AS DOUBLE)))
    END AS needed_total,
    1 AS hit
  FROM (
    SELECT
      whole.asset AS asset,
      whole.channel AS channel,
      whole.vectors AS vectors,
      LN(whole.floor) - LN(NULLIF(CAST(:target_floor AS DOUBLE), CAST(0 AS DOUBLE))) AS descent,
      LN(half.learned_floor / whole.floor)
      / LN(CAST(whole.vectors AS DOUBLE) / CAST(half.learned_vectors AS DOUBLE)) AS exponent
    FROM floors AS whole
    JOIN learning AS half ON half.asset = whole.asset AND half.channel = whole.channel
    WHERE whole.level = 0
      AND whole.blocks >= 4
      AND whole.floor > CAST(0 AS DOUBLE)
      AND half.learned_floor > whole.floor
      AND half.block = CAST(FLOOR(CAST(whole.blocks AS DOUBLE) / CAST(2 AS DOUBLE)) AS BIGINT) - 1
  ) AS halves
) AS ahead ON ahead.asset = known.asset AND ahead.channel = known.channel
WHERE known.level = 0
