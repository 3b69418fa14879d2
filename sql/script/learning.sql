-- Learning: what the first blocks of calibration know: their vectors, their cells, and their floor.
-- Reads:  blocks, learned
SELECT
  asset,
  channel,
  block AS pool_block,
  learned_vectors,
  learned_cells,
  CAST(novel_units AS DOUBLE) / (units * CAST(block + 1 AS DOUBLE)) AS learned_floor
FROM (
  SELECT
    size.asset AS asset,
    size.channel AS channel,
    size.block AS block,
    size.units AS units,
    CAST(
      SUM(size.vectors) OVER (
        PARTITION BY size.asset, size.channel ORDER BY size.block ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS learned_vectors,
    CAST(
      SUM(CASE WHEN changed.hit = 1 THEN changed.new_cells ELSE 0 END) OVER (
        PARTITION BY size.asset, size.channel ORDER BY size.block ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS learned_cells,
    CAST(
      SUM(CASE WHEN changed.hit = 1 THEN changed.share_units ELSE 0 END) OVER (
        PARTITION BY size.asset, size.channel ORDER BY size.block ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS novel_units
  FROM blocks AS size
  LEFT JOIN (
    SELECT
      asset,
      channel,
      block,
      CAST(SUM(part.new_cells) AS BIGINT) AS new_cells,
      CAST(SUM(part.share_units) AS BIGINT) AS share_units,
      1 AS hit
    FROM learned AS part
    GROUP BY asset, channel, block
  ) AS changed ON changed.asset = size.asset AND changed.channel = size.channel AND changed.block = size.block
  WHERE size.level = 0
) AS running
