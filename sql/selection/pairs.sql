-- Pairs: how often each pair of bins occurs at each lag, both samples known and in one run.
-- Reads:  selected, lags, extents
-- A row:  one pair of bins that occurs at one lag of one channel.
-- Slots:  :bins   equal bins over the range, a power of two
SELECT channel_id, delay, bin_now, bin_then, CAST(COUNT(*) AS BIGINT) AS pairs
FROM (
  SELECT
    later.channel_id AS channel_id,
    earlier.delay AS delay,
    CAST(
      FLOOR(
        CAST(later.level - 1 AS DOUBLE) * CAST(:bins AS DOUBLE) / CAST(16384 AS DOUBLE)
      ) AS SMALLINT
    ) AS bin_now,
    CAST(
      FLOOR(
        CAST(earlier.level - 1 AS DOUBLE) * CAST(:bins AS DOUBLE) / CAST(16384 AS DOUBLE)
      ) AS SMALLINT
    ) AS bin_then
  FROM (
    SELECT
      taken.channel_id AS channel_id,
      taken.run_no AS run_no,
      taken.level AS level,
      back.delay AS delay,
      taken.place + back.delay AS place_later
    FROM selected AS taken
    JOIN lags AS back ON back.channel_id = taken.channel_id
    JOIN extents AS extent ON extent.channel_id = taken.channel_id
    WHERE taken.level > 0 AND back.delay <= extent.longest_lag
  ) AS earlier
  JOIN (
    SELECT channel_id, run_no, place, level
    FROM selected
    WHERE level > 0
  ) AS later
    ON later.channel_id = earlier.channel_id
    AND later.run_no = earlier.run_no
    AND later.place = earlier.place_later
) AS binned
GROUP BY channel_id, delay, bin_now, bin_then
