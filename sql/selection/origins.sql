-- Origins: the usable samples, as vectors of one coordinate from which the embedding unfolds.
-- Reads:  selected, delays
-- A row:  one usable sample; depth counts the coordinates that are known without a gap.
SELECT
  taken.channel_id AS channel_id,
  taken.run_no AS run_no,
  taken.place AS place,
  given.embedded_tau AS tau,
  given.memory AS memory,
  1 AS depth,
  taken.scaled AS u_0
FROM selected AS taken
JOIN delays AS given ON given.channel_id = taken.channel_id
WHERE taken.scaled >= CAST(0 AS DOUBLE)
