-- Granules: the beginning of each channel in pieces that blocks of each scale are made of, so that its samples are put
-- in order once. The further on in a quarter, the larger they are: as large as the shortest blocks that reach there. A
-- granule sums up codes of samples, which are between 0 and 1023 over the whole range of the channel.
-- Reads:  head_samples
-- A row:  one granule of one quarter of one channel that holds a value; granule_no counts granules of its size. samples
--         are those with a value, first_time and last_time theirs. Codes are 0 where all values are one.
-- Slots:  :size  samples of a granule, by its place
SELECT
  coded.channel_id AS channel_id,
  coded.quarter AS quarter,
  coded.size AS size,
  coded.granule_no AS granule_no,
  CAST(COUNT(*) AS BIGINT) AS samples,
  CAST(SUM(coded.code) AS BIGINT) AS code_sum,
  MIN(coded.time) AS first_time,
  MAX(coded.time) AS last_time
FROM (
  SELECT
    sized.channel_id AS channel_id,
    sized.time AS time,
    sized.quarter AS quarter,
    sized.size AS size,
    CAST(FLOOR(CAST(sized.place AS DOUBLE) / CAST(sized.size AS DOUBLE)) AS BIGINT) AS granule_no,
    CASE
      WHEN sized.lowest < sized.highest
        THEN CAST(
          FLOOR(
            (sized.value - sized.lowest) / (sized.highest - sized.lowest) * CAST(1023 AS DOUBLE)
          ) AS BIGINT
        )
      ELSE 0
    END AS code
  FROM (
    SELECT
      early.channel_id AS channel_id,
      early.time AS time,
      early.value AS value,
      early.lowest AS lowest,
      early.highest AS highest,
      early.quarter AS quarter,
      early.place AS place,
      :size AS size
    FROM head_samples AS early
    WHERE early.value IS NOT NULL
  ) AS sized
) AS coded
GROUP BY coded.channel_id, coded.quarter, coded.size, coded.granule_no
