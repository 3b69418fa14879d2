-- Outlook: how much more calibration would bring the floor down to the target. The learning curve is
-- carried on as a power of the number of vectors, with the exponent seen between half of the blocks
-- and all of them. No figure where it does not fall, where there are fewer than 4 blocks, or beyond
-- 1000 times the present calibration: that would be a guess. Never less than it takes to be judged at all.
-- Reads:  spread, learning
-- A row:  one support; needed_total in vectors, NULL where there is no figure.
-- Slots:  :target_floor
--         :least_vectors  calibration vectors below which a floor promises nothing
SELECT
  support_spread.support_id AS support_id,
  support_spread.vectors AS vectors,
  CASE
    WHEN ahead.hit = 1 AND ahead.needed_total > CAST(:least_vectors AS DOUBLE) THEN ahead.needed_total
    WHEN support_spread.vectors < :least_vectors THEN CAST(:least_vectors AS DOUBLE)
    WHEN ahead.hit = 1 THEN ahead.needed_total
  END AS needed_total
FROM spread AS support_spread
LEFT JOIN (
  SELECT
    support_id,
    CASE
      WHEN descent <= exponent * LN(CAST(1000 AS DOUBLE))
        THEN CAST(vectors AS DOUBLE) * EXP(descent / NULLIF(exponent, CAST(0 AS DOUBLE)))
    END AS needed_total,
    1 AS hit
  FROM (
    SELECT
      whole.support_id AS support_id,
      whole.vectors AS vectors,
      LN(whole.floor) - LN(NULLIF(CAST(:target_floor AS DOUBLE), CAST(0 AS DOUBLE))) AS descent,
      LN(half.learned_floor / whole.floor)
      / LN(CAST(whole.vectors AS DOUBLE) / CAST(half.learned_vectors AS DOUBLE)) AS exponent
    FROM spread AS whole
    JOIN learning AS half
      ON half.support_id = whole.support_id
    WHERE whole.blocks >= 4
      AND whole.floor > CAST(0 AS DOUBLE)
      AND half.learned_floor > whole.floor
      AND half.pool_block
        = CAST(FLOOR(CAST(whole.blocks AS DOUBLE) / CAST(2 AS DOUBLE)) AS BIGINT) - 1
  ) AS halves
) AS ahead ON ahead.support_id = support_spread.support_id
