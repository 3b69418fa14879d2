-- Certified: what the frozen intervals of calibration would say now of cells, blocks and the certificate, beside
-- what is stored.
-- Reads:  cohort, cells, blocks, verdicts, stored_support, stored_block, stored_bounds, stored_version
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
  SELECT 'bounds' AS part, support_id, 0 AS place
  FROM (
    SELECT DISTINCT
      member.support_id AS support_id,
      judged.vectors AS calibration_vectors,
      judged.cells AS cells,
      judged.seen_once AS seen_once,
      judged.blocks AS blocks,
      judged.verdict AS verdict,
      judged.floor AS floor,
      judged.floor_sd AS floor_sd,
      judged.floor_max AS floor_max,
      judged.finest_bins AS finest_bins,
      judged.vectors_needed AS vectors_needed,
      0 AS is_stored
    FROM verdicts AS judged
    JOIN cohort AS member ON member.channel_id = judged.channel_id
    UNION ALL
    SELECT
      learnt.support_id AS support_id,
      learnt.calibration_vectors AS calibration_vectors,
      learnt.cells AS cells,
      learnt.seen_once AS seen_once,
      learnt.blocks AS blocks,
      learnt.verdict AS verdict,
      learnt.floor AS floor,
      learnt.floor_sd AS floor_sd,
      learnt.floor_max AS floor_max,
      learnt.finest_bins AS finest_bins,
      learnt.vectors_needed AS vectors_needed,
      1 AS is_stored
    FROM stored_bounds AS learnt
    JOIN (
      SELECT DISTINCT support_id
      FROM cohort
    ) AS needed ON needed.support_id = learnt.support_id
  ) AS both_bounds
  GROUP BY
    support_id,
    calibration_vectors,
    cells,
    seen_once,
    blocks,
    verdict,
    floor,
    floor_sd,
    floor_max,
    finest_bins,
    vectors_needed
  HAVING COUNT(*) <> 2 * SUM(is_stored)
) AS matched
GROUP BY matched.part, matched.support_id
