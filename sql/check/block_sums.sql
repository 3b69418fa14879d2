-- Block sums: the codes of a channel summed over the blocks of each scale. Blocks with a missing sample are left
-- out, and so are those that are not full.
-- Reads:  granules, scales, movements
-- A row:  one block of one quarter of one channel that moves, at one scale.
SELECT
  part.channel_id AS channel_id,
  part.scale AS scale,
  part.quarter AS quarter,
  part.block_no AS block_no,
  CAST(SUM(part.code_sum) AS BIGINT) AS code_sum
FROM (
  SELECT
    granule.channel_id AS channel_id,
    rung.scale AS scale,
    granule.quarter AS quarter,
    CAST(
      FLOOR(CAST(granule.granule_no * granule.size AS DOUBLE) / CAST(rung.scale AS DOUBLE)) AS BIGINT
    ) AS block_no,
    granule.samples AS samples,
    granule.code_sum AS code_sum
  FROM granules AS granule
  JOIN movements AS extent ON extent.channel_id = granule.channel_id
  CROSS JOIN scales AS rung
  WHERE extent.lowest < extent.highest AND granule.size <= rung.scale
) AS part
GROUP BY part.channel_id, part.scale, part.quarter, part.block_no
HAVING SUM(part.samples) = MAX(part.scale)
