-- Missing vectors, one channel: as certificate/missing_vectors.sql. For DuckDB, by streams/vectors.sql. Proof: the
-- vectors of calibration and the scored ones, which hold every row.
-- Reads:  streamed, the samples of the channel
-- A row:  the channel, if it has such a vector.
SELECT CAST(COUNT(*) AS BIGINT) AS missing_vectors
FROM streamed
WHERE whole = 1 AND cell_key IS NULL
HAVING COUNT(*) > 0
