-- Missing vectors: the vectors of the whole channel that contain a missing sample; they are neither
-- learnt nor scored (method, section 2).
-- Reads:  vectors
-- A row:  one channel that has such a vector.
SELECT channel_id, CAST(COUNT(*) AS BIGINT) AS missing_vectors
FROM vectors
WHERE cell_key IS NULL
GROUP BY channel_id
