-- Certified: what the frozen intervals of calibration would say now of cells, blocks and the certificate, beside
-- what is stored. Supports of before ladders were kept have none.
-- Reads:  cohort, cells, blocks, ladder, verdicts, stored_support, stored_block, stored_ladder, stored_bounds,
--         stored_version
-- A row:  one support and part of it that differs: how many rows do.
SELECT
  matched.part AS part,
  matched.support_id AS support_id,
  CAST(COUNT(*) AS BIGINT) AS differing
FROM (
  SELECT 'support' AS part, support_id, cell_key AS place
  FROM (
    SELECT support_id, cell_key, visits, first_block, last_block, first_time, last_time, 0 AS is_stored
    FROM cells
    UNION ALL
    SELECT
      cell.support_id AS support_id,
      cell.cell_key AS cell_key,
      cell.visits AS visits,
      cell.first_block AS first_block,
      cell.last_block AS last_block,
      cell.first_time AS first_time,
      cell.last_time AS last_time,
      1 AS is_stored
    FROM stored_support AS cell
    JOIN (
      SELECT DISTINCT support_id
      FROM cohort
    ) AS needed ON needed.support_id = cell.support_id
  ) AS both_cells
  GROUP BY support_id, cell_key, visits, first_block, last_block, first_time, last_time
  HAVING COUNT(*) <> 2 * SUM(is_stored)
  UNION ALL
  SELECT 'block' AS part, support_id, block AS place
  FROM (
    SELECT
      part.support_id AS support_id,
      part.pool_block AS block,
      owner.channel_id AS channel_id,
      part.first_time AS first_time,
      part.last_time AS last_time,
      part.vectors AS vectors,
      part.novel AS novel,
      0 AS is_stored
    FROM blocks AS part
    JOIN cohort AS member ON member.channel_id = part.channel_id
    JOIN stored_version AS owner ON owner.version_id = member.version_id
    UNION ALL
    SELECT
      part.support_id AS support_id,
      part.block AS block,
      part.channel_id AS channel_id,
      part.first_time AS first_time,
      part.last_time AS last_time,
      part.vectors AS vectors,
      part.novel AS novel,
      1 AS is_stored
    FROM stored_block AS part
    JOIN (
      SELECT DISTINCT support_id
      FROM cohort
    ) AS needed ON needed.support_id = part.support_id
  ) AS both_blocks
  GROUP BY support_id, block, channel_id, first_time, last_time, vectors, novel
  HAVING COUNT(*) <> 2 * SUM(is_stored)
  UNION ALL
  SELECT 'ladder' AS part, support_id, bins AS place
  FROM (
    SELECT step.support_id AS support_id, step.level_bins AS bins, step.floor AS floor, 0 AS is_stored
    FROM ladder AS step
    JOIN (
      SELECT DISTINCT support_id
      FROM stored_ladder
    ) AS kept ON kept.support_id = step.support_id
    UNION ALL
    SELECT step.support_id AS support_id, step.bins AS bins, step.floor AS floor, 1 AS is_stored
    FROM stored_ladder AS step
    JOIN (
      SELECT DISTINCT support_id
      FROM cohort
    ) AS needed ON needed.support_id = step.support_id
  ) AS both_ladders
  GROUP BY support_id, bins
  HAVING COUNT(*) <> 2 * SUM(is_stored) OR MIN(floor) <> MAX(floor) OR COUNT(floor) = 1
  UNION ALL
  SELECT 'bounds' AS part, learnt.support_id AS support_id, 0 AS place
  FROM stored_bounds AS learnt
  JOIN (
    SELECT
      member.support_id AS support_id,
      MIN(judged.vectors) AS calibration_vectors,
      MIN(judged.cells) AS cells,
      MIN(judged.seen_once) AS seen_once,
      MIN(judged.blocks) AS blocks,
      MIN(judged.verdict) AS verdict,
      MIN(judged.floor) AS floor,
      MIN(judged.floor_sd) AS floor_sd,
      MIN(judged.floor_max) AS floor_max,
      MIN(judged.finest_bins) AS finest_bins,
      MIN(judged.vectors_needed) AS vectors_needed
    FROM verdicts AS judged
    JOIN cohort AS member ON member.channel_id = judged.channel_id
    GROUP BY member.support_id
  ) AS again ON again.support_id = learnt.support_id
  WHERE CASE
    WHEN again.calibration_vectors <> learnt.calibration_vectors THEN 1
    WHEN again.cells <> learnt.cells THEN 1
    WHEN again.seen_once <> learnt.seen_once THEN 1
    WHEN again.blocks <> learnt.blocks THEN 1
    WHEN again.verdict <> learnt.verdict THEN 1
    WHEN again.floor <> learnt.floor THEN 1
    WHEN again.floor IS NULL AND learnt.floor IS NOT NULL THEN 1
    WHEN again.floor IS NOT NULL AND learnt.floor IS NULL THEN 1
    WHEN again.floor_sd <> learnt.floor_sd THEN 1
    WHEN again.floor_sd IS NULL AND learnt.floor_sd IS NOT NULL THEN 1
    WHEN again.floor_sd IS NOT NULL AND learnt.floor_sd IS NULL THEN 1
    WHEN again.floor_max <> learnt.floor_max THEN 1
    WHEN again.floor_max IS NULL AND learnt.floor_max IS NOT NULL THEN 1
    WHEN again.floor_max IS NOT NULL AND learnt.floor_max IS NULL THEN 1
    WHEN again.finest_bins <> learnt.finest_bins THEN 1
    WHEN again.finest_bins IS NULL AND learnt.finest_bins IS NOT NULL THEN 1
    WHEN again.finest_bins IS NOT NULL AND learnt.finest_bins IS NULL THEN 1
    WHEN again.vectors_needed <> learnt.vectors_needed THEN 1
    WHEN again.vectors_needed IS NULL AND learnt.vectors_needed IS NOT NULL THEN 1
    WHEN again.vectors_needed IS NOT NULL AND learnt.vectors_needed IS NULL THEN 1
    ELSE 0
  END = 1
) AS matched
GROUP BY matched.part, matched.support_id
