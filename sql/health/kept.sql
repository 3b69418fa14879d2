-- Kept: of all scored vectors only those that the buckets need: the novel ones, and the first and last
-- of each bucket. On a healthy machine that is a few per cent.
-- Reads:  placed
-- A row:  one scored vector; closing = 1 if its bucket ends with it.
-- Slots:  :stride   vectors per bucket
--         :carried  columns that travel with the vector
--         :needed   what else makes a vector stay
SELECT
  channel_id,
  CAST(FLOOR((CAST(number AS DOUBLE) - CAST(5e-1 AS DOUBLE)) / CAST(:stride AS DOUBLE)) AS BIGINT)
    AS bucket_no,
  time,
  cell_key,
  novel,
  out_of_range,
  :carried,
  CASE WHEN number % :stride = 0 THEN 1 ELSE 0 END AS closing
FROM placed
WHERE novel = 1 OR number % :stride = 0 OR (number - 1) % :stride = 0 OR :needed
