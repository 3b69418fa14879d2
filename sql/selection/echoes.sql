-- Echoes: what the autocorrelation at each lag is made of, in exact integers: levels about the middle of
-- their range, multiplied and summed. Of a long channel the earlier samples are those of pairs.sql.
-- Repeated by Python, once per scale.
-- Reads:  selected, lags, extents
-- A row:  one lag of one channel that has a pair.
-- Slots:  :scale        samples that one row stands for
--         :least        samples of a channel for which this scale is of use
--         :most         samples of a channel up to which all rows of this scale are taken
SELECT
  channel_id,
  CAST(:scale AS BIGINT) AS scale,
  delay,
  CAST(COUNT(*) AS BIGINT) AS n_pairs,
  CAST(SUM(now_level) AS BIGINT) AS now_sum,
  CAST(SUM(then_level) AS BIGINT) AS then_sum,
  CAST(SUM(now_level * now_level) AS BIGINT) AS now_squares,
  CAST(SUM(then_level * then_level) AS BIGINT) AS then_squares,
  CAST(SUM(now_level * then_level) AS BIGINT) AS products
FROM (
  SELECT
    earlier.channel_id AS channel_id,
    earlier.delay AS delay,
    earlier.centred_level AS then_level,
    later.centred_level AS now_level
  FROM (
    SELECT
      taken.channel_id AS channel_id,
      taken.run_no AS run_no,
      CAST(taken.level AS BIGINT) - 8192 AS centred_level,
      back.delay AS delay,
      taken.place + back.delay AS place_later
    FROM (
      SELECT
        sampled.channel_id AS channel_id,
        sampled.run_no AS run_no,
        sampled.place AS place,
        sampled.level AS level
      FROM selected AS sampled
      JOIN extents AS extent ON extent.channel_id = sampled.channel_id
      WHERE sampled.level > 0 AND extent.samples >= :least
        AND ((sampled.place * 40503) % 65536) * extent.samples < 65536 * CAST(:most AS BIGINT)
    ) AS taken
    JOIN lags AS back ON back.channel_id = taken.channel_id
  ) AS earlier
  JOIN (
    SELECT channel_id, run_no, place, CAST(level AS BIGINT) - 8192 AS centred_level
    FROM selected
    WHERE level > 0
  ) AS later
    ON later.channel_id = earlier.channel_id
    AND later.run_no = earlier.run_no
    AND later.place = earlier.place_later
) AS paired
GROUP BY channel_id, delay
