-- Pairs: how often each pair of bins occurs at each lag, both samples known and in one run. Of a long
-- channel the earlier samples are about :most, spread evenly over it: by multiples of 40503 / 65536, the golden
-- section, which keep step with no cycle. All lags take the same ones.
-- Reads:  selected, lags, extents
-- A row:  one pair of bins that occurs at one lag of one channel.
-- Slots:  :bins   equal bins over the range, a power of two
--         :most   samples of a channel up to which all are taken
SELECT channel_id, delay, bin_now, bin_then, CAST(COUNT(*) AS BIGINT) AS pairs
FROM (
  SELECT
    later.channel_id AS channel_id,
    earlier.delay AS delay,
    later.bin_now AS bin_now,
    earlier.bin_then AS bin_then
  FROM (
    SELECT
      taken.channel_id AS channel_id,
      taken.run_no AS run_no,
      taken.bin_then AS bin_then,
      back.delay AS delay,
      taken.place + back.delay AS place_later
    FROM (
      SELECT
        sampled.channel_id AS channel_id,
        sampled.run_no AS run_no,
        sampled.place AS place,
        CAST(
          FLOOR(CAST(sampled.level - 1 AS DOUBLE) * CAST(:bins AS DOUBLE) / CAST(16384 AS DOUBLE)) AS SMALLINT
        ) AS bin_then,
        extent.longest_lag AS longest_lag
      FROM selected AS sampled
      JOIN extents AS extent ON extent.channel_id = sampled.channel_id
      WHERE sampled.level > 0
        AND ((sampled.place * 40503) % 65536) * extent.samples < 65536 * CAST(:most AS BIGINT)
    ) AS taken
    JOIN lags AS back ON back.channel_id = taken.channel_id
    WHERE back.delay <= taken.longest_lag
  ) AS earlier
  JOIN (
    SELECT
      channel_id,
      run_no,
      place,
      CAST(
        FLOOR(CAST(level - 1 AS DOUBLE) * CAST(:bins AS DOUBLE) / CAST(16384 AS DOUBLE)) AS SMALLINT
      ) AS bin_now
    FROM selected
    WHERE level > 0
  ) AS later
    ON later.channel_id = earlier.channel_id
    AND later.run_no = earlier.run_no
    AND later.place = earlier.place_later
) AS binned
GROUP BY channel_id, delay, bin_now, bin_then
