-- Certified extents: what the frozen intervals of calibration would say now of judgements, beside what is stored.
-- Versions of before that was kept have none.
-- Reads:  cohort, buffered, bands, block_sizes, order_ratios, lengths, stored_buffered, stored_band, stored_extent
-- A row:  one version and part of it that differs: how many rows do.
SELECT
  matched.version_id AS version_id,
  matched.part AS part,
  CAST(COUNT(*) AS BIGINT) AS differing
FROM (
  SELECT 'buffered' AS part, version_id, block AS place
  FROM (
    SELECT
      member.version_id AS version_id,
      part.block AS block,
      part.g AS g,
      part.vectors AS vectors,
      part.novel_buffered AS novel_buffered,
      0 AS is_stored
    FROM buffered AS part
    JOIN cohort AS member ON member.channel_id = part.channel_id
    UNION ALL
    SELECT
      part.version_id AS version_id,
      part.block AS block,
      part.g AS g,
      part.vectors AS vectors,
      part.novel_buffered AS novel_buffered,
      1 AS is_stored
    FROM stored_buffered AS part
    JOIN cohort AS member ON member.version_id = part.version_id
  ) AS both_blocks
  GROUP BY version_id, block, g, vectors, novel_buffered
  HAVING COUNT(*) <> 2 * SUM(is_stored)
  UNION ALL
  SELECT 'band' AS part, version_id, band AS place
  FROM (
    SELECT
      member.version_id AS version_id,
      part.g AS g,
      part.band AS band,
      part.visits AS visits,
      part.novel_buffered AS novel_buffered,
      0 AS is_stored
    FROM bands AS part
    JOIN cohort AS member ON member.channel_id = part.channel_id
    UNION ALL
    SELECT
      part.version_id AS version_id,
      part.g AS g,
      part.band AS band,
      part.visits AS visits,
      part.novel_buffered AS novel_buffered,
      1 AS is_stored
    FROM stored_band AS part
    JOIN cohort AS member ON member.version_id = part.version_id
  ) AS both_bands
  GROUP BY version_id, g, band, visits, novel_buffered
  HAVING COUNT(*) <> 2 * SUM(is_stored)
  UNION ALL
  SELECT 'extent' AS part, version_id, 0 AS place
  FROM (
    SELECT
      member.version_id AS version_id,
      CASE WHEN taught.hit = 1 THEN taught.vectors ELSE 0 END AS vectors,
      CASE WHEN lasting.hit = 1 THEN lasting.length ELSE 0 END AS calibration_length,
      CASE WHEN ordered.hit = 1 THEN ordered.order_ratio END AS order_ratio,
      0 AS is_stored
    FROM cohort AS member
    LEFT JOIN (
      SELECT channel_id, order_ratio, 1 AS hit
      FROM order_ratios
    ) AS ordered ON ordered.channel_id = member.channel_id
    LEFT JOIN (
      SELECT channel_id, length, 1 AS hit
      FROM lengths
    ) AS lasting ON lasting.channel_id = member.channel_id
    LEFT JOIN (
      SELECT channel_id, CAST(SUM(size.vectors) AS BIGINT) AS vectors, 1 AS hit
      FROM block_sizes AS size
      GROUP BY channel_id
    ) AS taught ON taught.channel_id = member.channel_id
    UNION ALL
    SELECT
      extent.version_id AS version_id,
      extent.vectors AS vectors,
      extent.calibration_length AS calibration_length,
      extent.order_ratio AS order_ratio,
      1 AS is_stored
    FROM stored_extent AS extent
    JOIN cohort AS member ON member.version_id = extent.version_id
  ) AS both_extents
  GROUP BY version_id, vectors, calibration_length, order_ratio
  HAVING COUNT(*) <> 2 * SUM(is_stored)
) AS matched
JOIN (
  SELECT version_id, 'buffered' AS part
  FROM stored_buffered
  UNION
  SELECT version_id, 'buffered' AS part
  FROM stored_extent
  UNION
  SELECT version_id, 'extent' AS part
  FROM stored_buffered
  UNION
  SELECT version_id, 'extent' AS part
  FROM stored_extent
  UNION
  SELECT version_id, 'band' AS part
  FROM stored_band
) AS kept ON kept.version_id = matched.version_id AND kept.part = matched.part
GROUP BY matched.version_id, matched.part
