-- Visits, in stored order: how often each block of the calibration of one channel visited each cell; as
-- certificate/visits.sql. For DuckDB, by streams/vectors.sql: a vector's place in calibration is told by the number of
-- its row, so that nothing is sorted. Proof: all visits of a channel add up to its vectors, which block numbers are made
-- of, and no row has doubled = 1 (streams/visited_vectors.sql).
-- Reads:  streamed, the samples of the channel's calibration.
-- A row:  one cell in one block, or NULL; doubled = 1 if one of its vectors, or a sample without a vector, is not
--         later than the sample before.
-- Slots:  :counted   whether a sample ends a vector that counts
--         :number    the number of the vector, from 1
--         :block_no  the expression of certificate/block_no.sql, of place
SELECT
  block_no,
  cell_key,
  CAST(COUNT(*) AS BIGINT) AS visits,
  MIN(learnt.time) AS first_time,
  MAX(learnt.time) AS last_time,
  MAX(learnt.out_of_order) AS doubled
FROM (
  SELECT time, cell_key, CAST(:block_no AS BIGINT) AS block_no, out_of_order
  FROM (
    SELECT time, cell_key, :number - 1 AS place, out_of_order
    FROM streamed
    WHERE :counted OR out_of_order = 1
  ) AS learnable
) AS learnt
GROUP BY block_no, cell_key
