-- Coarser: the same series at half the rate, two neighbours averaged: a long cycle is a short lag there.
-- Reads:  selected
-- A row:  two samples of one run, or one at its edge; 0 where both are missing.
SELECT
  channel_id,
  run_no,
  place,
  CAST(
    CASE
      WHEN present = 0 THEN 0
      ELSE FLOOR(
        CAST(total AS DOUBLE) / NULLIF(CAST(present AS DOUBLE), CAST(0 AS DOUBLE))
        + CAST(5e-1 AS DOUBLE)
      )
    END AS SMALLINT
  ) AS level
FROM (
  SELECT
    channel_id,
    run_no,
    half_place AS place,
    CAST(SUM(CASE WHEN level > 0 THEN 1 ELSE 0 END) AS BIGINT) AS present,
    CAST(SUM(level) AS BIGINT) AS total
  FROM (
    SELECT
      channel_id,
      run_no,
      CAST(FLOOR(CAST(finer.place AS DOUBLE) / CAST(2 AS DOUBLE)) AS BIGINT) AS half_place,
      level
    FROM selected AS finer
  ) AS halved
  GROUP BY channel_id, run_no, half_place
) AS summed
