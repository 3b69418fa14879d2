-- Head samples: the beginning of each channel, cut into quarters, for the looks whose work must be bounded.
-- Reads:  samples, movements
-- A row:  one sample; place counts from 0 in its quarter.
-- Slots:  :longest_sample  the samples of a channel that are looked at
SELECT
  head.channel_id AS channel_id,
  head.time AS time,
  head.value AS value,
  head.lowest AS lowest,
  head.highest AS highest,
  head.quarter AS quarter,
  head.place
    - CAST(
      FLOOR(CAST(head.quarter * head.head_length + 3 AS DOUBLE) / CAST(4 AS DOUBLE)) AS BIGINT
    ) AS place
FROM (
  SELECT
    early.channel_id AS channel_id,
    early.time AS time,
    early.value AS value,
    early.lowest AS lowest,
    early.highest AS highest,
    early.place AS place,
    early.head_length AS head_length,
    CAST(
      FLOOR(CAST(4 * early.place AS DOUBLE) / CAST(early.head_length AS DOUBLE)) AS BIGINT
    ) AS quarter
  FROM (
    SELECT
      sampled.channel_id AS channel_id,
      sampled.time AS time,
      sampled.value AS value,
      extent.lowest AS lowest,
      extent.highest AS highest,
      CASE WHEN extent.samples < :longest_sample THEN extent.samples ELSE :longest_sample END
        AS head_length,
      CAST(
        ROW_NUMBER() OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time) AS BIGINT
      ) - 1 AS place
    FROM samples AS sampled
    JOIN movements AS extent ON extent.channel_id = sampled.channel_id
    WHERE sampled.time <= extent.sample_end
  ) AS early
) AS head
