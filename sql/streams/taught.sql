-- Taught, one channel: how many vectors its calibration teaches, where samples are missing or segments end; block
-- numbers are made of it. For DuckDB, by streams/vectors.sql. Proof: that of streams/visits.sql.
-- Reads:  streamed, the samples of the channel's calibration.
-- A row:  the channel.
-- Slots:  :counted  whether a sample ends a vector that counts
SELECT CAST(COUNT(CASE WHEN :counted THEN cell_key END) AS BIGINT) AS vectors
FROM streamed
