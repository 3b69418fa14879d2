-- Pairs: how often each pair of bins occurs at one lag, both samples known and in one run.
-- Repeated by Python, once per lag, and stacked.
-- Reads:  lagged
-- A row:  one pair of bins that occurs.
-- Slots:  :lag    in samples; 0 pairs each sample with itself
--         :level  the column with the level that lag ago
--         :bins   equal bins over the range, a power of two
SELECT channel_id, lag, bin_now, bin_then, CAST(COUNT(*) AS BIGINT) AS pairs
FROM (
  SELECT
    channel_id,
    CAST(:lag AS INTEGER) AS lag,
    CAST(
      FLOOR(
        CAST(level_0 - 1 AS DOUBLE) * CAST(:bins AS DOUBLE) / CAST(16384 AS DOUBLE)
      ) AS SMALLINT
    ) AS bin_now,
    CAST(
      FLOOR(
        CAST(:level - 1 AS DOUBLE) * CAST(:bins AS DOUBLE) / CAST(16384 AS DOUBLE)
      ) AS SMALLINT
    ) AS bin_then
  FROM lagged
  WHERE level_0 > 0 AND :level > 0
) AS binned
GROUP BY channel_id, lag, bin_now, bin_then
