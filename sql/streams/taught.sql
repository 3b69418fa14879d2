-- Taught, one channel: how many vectors its calibration teaches, where samples are missing or segments end; block
-- numbers are made of it. For DuckDB, by streams/vectors.sql. Proof: that of streams/visits.sql.
-- Reads:  streamed, the samples of the channel's calibration.
-- A row:  the channel.
SELECT CAST(COUNT(CASE WHEN whole = 1 THEN cell_key END) AS BIGINT) AS vectors
FROM streamed
