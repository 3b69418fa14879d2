-- Block sums: the codes of a channel, between 0 and 1023 over its whole range, summed over the blocks of
-- each scale. Blocks with a missing sample are left out, and so are those that are not full.
-- Reads:  head_samples, scales
-- A row:  one block of one quarter of one channel, at one scale.
-- Slots:  :blocks  the blocks of a quarter, at every scale
SELECT
  coded.channel_id AS channel_id,
  coded.scale AS scale,
  coded.quarter AS quarter,
  coded.block_no AS block_no,
  CAST(SUM(coded.code) AS BIGINT) AS code_sum
FROM (
  SELECT
    early.channel_id AS channel_id,
    rung.scale AS scale,
    early.quarter AS quarter,
    CAST(FLOOR(CAST(early.place AS DOUBLE) / CAST(rung.scale AS DOUBLE)) AS BIGINT) AS block_no,
    CAST(
      FLOOR(
        (early.value - early.lowest) / (early.highest - early.lowest) * CAST(1023 AS DOUBLE)
      ) AS BIGINT
    ) AS code
  FROM head_samples AS early
  CROSS JOIN scales AS rung
  WHERE early.value IS NOT NULL
    AND early.lowest < early.highest
    AND early.place < rung.scale * :blocks
) AS coded
GROUP BY coded.channel_id, coded.scale, coded.quarter, coded.block_no
HAVING COUNT(*) = MAX(coded.scale)
