-- Timeline of a scheduled run: the rows of each channel beyond the first of an instant.
-- Reads:  samples
-- A row:  one channel that has a row in its range.
SELECT sampled.channel_id AS channel_id, CAST(SUM(sampled.row_count - 1) AS BIGINT) AS repeats
FROM samples AS sampled
GROUP BY sampled.channel_id
