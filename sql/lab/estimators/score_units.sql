-- Score units: scores as integers of 2^-20, for sliding sums of doubles differ by engine. What is so large
-- that a window of such scores would leave 64 bits is taken for the largest that does not. Vectors are
-- numbered from 1 and cut into blocks of W.
-- Reads:  scores
-- A row:  one scored vector.
-- Slots:  :window  W, in vectors
--         :most    the most units of which a sum of W holds
SELECT
  channel_id,
  time,
  score,
  CASE
    WHEN scaled > CAST(:most AS DOUBLE) THEN :most
    WHEN scaled < -CAST(:most AS DOUBLE) THEN -:most
    ELSE CAST(FLOOR(scaled + CAST(5e-1 AS DOUBLE)) AS BIGINT)
  END AS units,
  number,
  CAST(FLOOR((CAST(number AS DOUBLE) - CAST(5e-1 AS DOUBLE)) / CAST(:window AS DOUBLE)) AS BIGINT)
    AS block_no
FROM (
  SELECT
    channel_id,
    time,
    score,
    score * CAST(1048576 AS DOUBLE) AS scaled,
    CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) AS number
  FROM scores
) AS numbered
