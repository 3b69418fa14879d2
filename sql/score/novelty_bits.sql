-- Novelty by bits: a(t) = 1 if the cell of v(t) is not in the support, else 0 (Eq. 4); as novelty, for engines
-- that ask for a bit of the support at less cost than for a cell.
-- Reads:  monitored, support_bits
-- A row:  one scored vector.
-- Slots:  :carried  columns that travel with the vector
--         :is_held  1 if the cell of the vector is in the support's bits
SELECT
  vector.channel_id AS channel_id,
  vector.time AS time,
  vector.cell_key AS cell_key,
  vector.out_of_range AS out_of_range,
  vector.position AS position,
  vector.context_time AS context_time,
  :carried,
  CASE WHEN healthy.hit = 1 AND :is_held = 1 THEN 0 ELSE 1 END AS novel
FROM monitored AS vector
LEFT JOIN (
  SELECT support_id, bits, 1 AS hit
  FROM support_bits
) AS healthy ON healthy.support_id = vector.support_id
