-- Patterns: the distinct vectors of d coordinates that can be followed to d + 1. Quantised signals repeat
-- theirs a thousandfold; of each, the first and the last occurrence are enough to find neighbours.
-- Reads:  sampled
-- A row:  one distinct vector of one channel.
-- Slots:  :d            coordinates
--         :coordinates  u_0 ... u_(d-1)
SELECT
  channel_id,
  :coordinates,
  MIN(place) AS first_place,
  MAX(place) AS last_place,
  CAST(COUNT(*) AS BIGINT) AS visits
FROM sampled
WHERE depth > :d
GROUP BY channel_id, :coordinates
