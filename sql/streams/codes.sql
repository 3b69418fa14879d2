-- Codes in stored order: the samples of one channel, coded (Phi, method section 3); as support/codes.sql. For DuckDB.
-- Proof: that of the vectors (streams/vectors.sql).
-- Reads:  readings
-- A row:  one sample.
-- Slots:  :asset, :channel  the names of the channel
--         :lo, :hi          its calibrated range. Not joined: a join hands on small pieces of rows late.
--         :time_from, :time_to  the instants that are read
--         :value         the reading, where it is a number; or as it is, where no sample is missing
--         :place, :code  the expressions of support/place.sql and support/code.sql
--         :carried       other columns of the sample, and whether a segment begins with it, where segments end
SELECT time, CAST(:code AS DOUBLE) AS code, :carried
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
