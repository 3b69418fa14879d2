-- Vectors in stored order: v(t) (Eq. 1) of one channel, whose rows come by time as they are stored. For DuckDB, whose
-- LAG without an order follows the rows, so that nothing is sorted or joined. Proof: out_of_order = 1 marks what is
-- not later than the row before; one such mark, and all is done again by embedding/vectors.sql. Rows that are in no
-- vector are proven in order by streams/in_order.sql. Codes and keys are whole numbers below 2^25 here and added up
-- as DOUBLE, which holds each of them and which DuckDB does not watch for overflow.
-- Reads:  codes
-- A row:  one sample, and what its codes and those before it come to: whole = 1 if they are those of a vector;
--         cell_key is NULL where a sample is missing.
-- Slots:  :delayed      code_1 ... code_(m-1), the delayed codes, and other columns over the same order
--         :is_present   all coordinates are there
--         :whole        whether the samples before are those of a vector
--         :cell_key     the mixed-radix integer of the coordinates
--         :coordinates  code_0 ... code_(m-1)
SELECT
  time,
  CASE WHEN :is_present THEN CAST(:cell_key AS BIGINT) END AS cell_key,
  :coordinates,
  position,
  CASE WHEN :whole THEN 1 ELSE 0 END AS whole,
  CASE WHEN time <= previous_time THEN 1 ELSE 0 END AS out_of_order
FROM (
  SELECT
    time,
    code AS code_0,
    :delayed,
    LAG(time, 1) OVER () AS previous_time,
    CAST(ROW_NUMBER() OVER () AS BIGINT) AS position
  FROM codes
) AS embedded
