-- Vectors in stored order: v(t) (Eq. 1) of one channel, whose rows come by time as they are stored. For DuckDB, whose
-- LAG without an order follows the rows, so that nothing is sorted or joined. Proof: out_of_order = 1 marks what is
-- not later than the row before; one such mark, and all is done again by embedding/vectors.sql. Rows that are in no
-- vector are proven in order by streams/in_order.sql. Codes and keys are whole numbers below 2^25 here and added up
-- as DOUBLE, which holds each of them and which DuckDB does not watch for overflow.
-- Reads:  readings
-- A row:  one sample, and what its codes and those before it come to: whole = 1 if they are those of a vector;
--         cell_key is NULL where a sample is missing.
-- Slots:  :asset, :channel  the names of the channel
--         :lo, :hi          its calibrated range. Not joined: a join hands on small pieces of rows late.
--         :time_from, :time_to  the instants that are read
--         :value         the reading, where it is a number; or as it is, where no sample is missing
--         :breaking      whether a segment begins with the sample, where segments end
--         :place, :code  the expressions of support/place.sql and support/code.sql
--         :delayed   code_1 ... code_(m-1), the delayed codes, and other columns over the same order
--         :known     all coordinates are there
--         :whole     whether the samples before are those of a vector
--         :cell_key  the mixed-radix integer of the coordinates
--         :coordinates  code_0 ... code_(m-1)
SELECT
  time,
  CASE WHEN :known THEN CAST(:cell_key AS BIGINT) END AS cell_key,
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
  FROM (
    SELECT time, CAST(:code AS DOUBLE) AS code, :breaking
    FROM (
      SELECT time, value, lo, hi, :place AS place
      FROM (
        SELECT
          reading.time AS time,
          :value AS value,
          :lo AS lo,
          :hi AS hi
        FROM readings AS reading
        WHERE reading.asset = :asset
          AND reading.channel = :channel
          AND reading.time BETWEEN :time_from AND :time_to
      ) AS ranged
    ) AS scaled
  ) AS coded
) AS embedded
