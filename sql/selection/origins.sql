-- Origins: the usable samples, as vectors of one coordinate from which the embedding unfolds. Coordinates
-- are whole units of 2^-24 of the range, so what is nearer than a unit is equal. Rounding parts equal
-- samples, and the more there are the more often the nearest neighbour is one of these, which then is
-- false in every dimension (Rhodes and Morari 1997); no converter resolves more than 24 bits, nor does a
-- 32-bit float. All distances are exact integers.
-- Reads:  selected, delays
-- A row:  one usable sample; depth counts the coordinates that are known without a gap; c_0 is its code.
-- Slots:  :code  of a scaled sample
SELECT
  taken.channel_id AS channel_id,
  taken.run_no AS run_no,
  taken.place AS place,
  delay_choice.embedded_tau AS tau,
  delay_choice.memory AS memory,
  1 AS depth,
  CAST(FLOOR(taken.scaled * CAST(16777216 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS INTEGER) AS u_0,
  :code AS c_0
FROM selected AS taken
JOIN delays AS delay_choice ON delay_choice.channel_id = taken.channel_id
WHERE taken.scaled >= CAST(0 AS DOUBLE)
