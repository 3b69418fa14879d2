-- Inconsistent versions: what must hold between a version and what it learnt, whatever the source. Versions of a
-- channel are numbered on; each has one row of bounds, the cells and the blocks that these count.
-- Reads:  checked, stored_bounds, stored_support, stored_block
-- A row:  one version; a column is 1 where that does not hold.
SELECT
  version_id,
  is_misnumbered,
  is_unbounded,
  is_miscelled,
  is_misblocked
FROM (
  SELECT
    version.version_id AS version_id,
    CASE
      WHEN version.status <> 'active' THEN 1
      WHEN version.reason <> 'first calibration'
        AND version.reason <> 'other settings'
        AND version.reason <> 'pool changed'
        AND version.reason <> 'asked for'
        THEN 1
      WHEN version.version_no = 1
        THEN CASE
          WHEN version.parent_id IS NOT NULL OR version.reason <> 'first calibration' THEN 1
          WHEN version.places > 1 THEN 1
          ELSE 0
        END
      WHEN version.parent_id IS NULL OR version.reason = 'first calibration' THEN 1
      WHEN version.version_no < 1 OR version.parent_id >= version.version_id THEN 1
      WHEN version.places > 1
        AND (version.parent_id <> version.previous_id OR version.version_no <> version.previous_no + 1)
        THEN 1
      ELSE 0
    END AS is_misnumbered,
    CASE
      WHEN bounded.hit = 1
        THEN CASE
          WHEN bounded.hits <> 1 OR bounded.calibrated_hi < bounded.calibrated_lo THEN 1
          WHEN bounded.calibrated_lo IS NULL AND bounded.calibrated_hi IS NOT NULL THEN 1
          WHEN bounded.calibrated_lo IS NOT NULL AND bounded.calibrated_hi IS NULL THEN 1
          WHEN bounded.calibrated_lo IS NULL AND (bounded.verdict <> 'no_data' OR bounded.blocks <> 0) THEN 1
          WHEN bounded.blocks = 0
            AND (
              bounded.verdict <> 'no_data'
              OR bounded.floor IS NOT NULL
              OR bounded.floor_sd IS NOT NULL
              OR bounded.floor_max IS NOT NULL
              OR bounded.finest_bins IS NOT NULL
              OR bounded.vectors_needed IS NOT NULL
            )
            THEN 1
          WHEN bounded.blocks > 0 AND (bounded.floor IS NULL OR bounded.floor_max IS NULL) THEN 1
          WHEN bounded.floor < CAST(0 AS DOUBLE) OR bounded.floor > bounded.floor_max THEN 1
          ELSE 0
        END
      ELSE 1
    END AS is_unbounded,
    CASE
      WHEN bounded.hit = 1 AND held.hit = 1
        THEN CASE
          WHEN held.cells <> bounded.cells OR held.seen_once <> bounded.seen_once THEN 1
          WHEN held.visits <> bounded.calibration_vectors OR held.is_inconsistent > 0 THEN 1
          ELSE 0
        END
      WHEN bounded.hit = 1 AND (bounded.cells <> 0 OR bounded.seen_once <> 0 OR bounded.calibration_vectors <> 0)
        THEN 1
      ELSE 0
    END AS is_miscelled,
    CASE
      WHEN bounded.hit = 1 AND cut.hit = 1
        THEN CASE
          WHEN cut.blocks <> bounded.blocks OR cut.vectors <> bounded.calibration_vectors THEN 1
          WHEN cut.first_block <> 0 OR cut.last_block <> cut.blocks - 1 OR cut.is_inconsistent > 0 THEN 1
          WHEN cut.highest <> bounded.floor_max THEN 1
          ELSE 0
        END
      WHEN bounded.hit = 1 AND bounded.blocks <> 0 THEN 1
      ELSE 0
    END AS is_misblocked
  FROM (
    SELECT
      version_id,
      support_id,
      parent_id,
      version_no,
      status,
      reason,
      CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY version_id) AS BIGINT) AS places,
      LAG(version_id, 1) OVER (PARTITION BY channel_id ORDER BY version_id) AS previous_id,
      LAG(version_no, 1) OVER (PARTITION BY channel_id ORDER BY version_id) AS previous_no
    FROM checked
  ) AS version
  LEFT JOIN (
    SELECT
      support_id,
      MIN(scale.calibrated_lo) AS calibrated_lo,
      MIN(scale.calibrated_hi) AS calibrated_hi,
      MIN(scale.calibration_vectors) AS calibration_vectors,
      MIN(scale.cells) AS cells,
      MIN(scale.seen_once) AS seen_once,
      MIN(scale.blocks) AS blocks,
      MIN(scale.verdict) AS verdict,
      MIN(scale.floor) AS floor,
      MIN(scale.floor_sd) AS floor_sd,
      MIN(scale.floor_max) AS floor_max,
      MIN(scale.finest_bins) AS finest_bins,
      MIN(scale.vectors_needed) AS vectors_needed,
      CAST(COUNT(*) AS BIGINT) AS hits,
      1 AS hit
    FROM stored_bounds AS scale
    GROUP BY support_id
  ) AS bounded ON bounded.support_id = version.support_id
  LEFT JOIN (
    SELECT
      cell.support_id AS support_id,
      CAST(COUNT(*) AS BIGINT) AS cells,
      CAST(SUM(CASE WHEN cell.visits = 1 THEN 1 ELSE 0 END) AS BIGINT) AS seen_once,
      CAST(SUM(cell.visits) AS BIGINT) AS visits,
      MAX(
        CASE
          WHEN cell.visits < 1 OR cell.first_time > cell.last_time THEN 1
          WHEN cell.first_block < 0 OR cell.first_block > cell.last_block THEN 1
          ELSE 0
        END
      ) AS is_inconsistent,
      1 AS hit
    FROM stored_support AS cell
    GROUP BY cell.support_id
  ) AS held ON held.support_id = version.support_id
  LEFT JOIN (
    SELECT
      part.support_id AS support_id,
      CAST(COUNT(*) AS BIGINT) AS blocks,
      CAST(SUM(part.vectors) AS BIGINT) AS vectors,
      MIN(part.block) AS first_block,
      MAX(part.block) AS last_block,
      MAX(CAST(part.novel AS DOUBLE) / CAST(part.vectors AS DOUBLE)) AS highest,
      MAX(
        CASE
          WHEN part.first_time > part.last_time THEN 1
          WHEN part.novel <> CASE WHEN exclusive.hit = 1 THEN exclusive.visits ELSE 0 END THEN 1
          WHEN member.hit = 1 THEN 0
          ELSE 1
        END
      ) AS is_inconsistent,
      1 AS hit
    FROM stored_block AS part
    LEFT JOIN (
      SELECT
        cell.support_id AS support_id,
        cell.first_block AS block,
        CAST(SUM(cell.visits) AS BIGINT) AS visits,
        1 AS hit
      FROM stored_support AS cell
      WHERE cell.first_block = cell.last_block
      GROUP BY cell.support_id, cell.first_block
    ) AS exclusive ON exclusive.support_id = part.support_id AND exclusive.block = part.block
    LEFT JOIN (
      SELECT DISTINCT support_id, channel_id, 1 AS hit
      FROM checked
    ) AS member ON member.support_id = part.support_id AND member.channel_id = part.channel_id
    WHERE part.vectors > 0
    GROUP BY part.support_id
  ) AS cut ON cut.support_id = version.support_id
) AS judged
WHERE is_misnumbered + is_unbounded + is_miscelled + is_misblocked > 0
