-- Verdicts: the floor of each channel on its grid, the finest grid on which it is low enough, and the verdict.
-- A floor may be above its target by 2^-40, what rounding takes.
-- Reads:  bounds, floors, support
-- Slots:  :bins           of the grid
--         :least_vectors  the fewest vectors of calibration
--         :target_floor   the largest floor of a channel that is ready
SELECT
  whole.asset AS asset,
  whole.channel AS channel,
  scale.calibrated_lo AS calibrated_lo,
  scale.calibrated_hi AS calibrated_hi,
  held.cells AS cells,
  held.seen_once AS seen_once,
  whole.vectors AS vectors,
  whole.blocks AS blocks,
  whole.floor AS floor,
  whole.floor_sd AS floor_sd,
  whole.floor_max AS floor_max,
  whole.finest_bins AS finest_bins,
  CASE
    WHEN scale.calibrated_hi = scale.calibrated_lo THEN 'constant'
    WHEN whole.finest_bins = :bins THEN 'ready'
    WHEN whole.finest_bins > 0 THEN 'too_fine'
    ELSE 'needs_data'
  END AS verdict
FROM (
  SELECT
    asset,
    channel,
    MAX(grid.vectors) AS vectors,
    MAX(grid.blocks) AS blocks,
    MAX(CASE WHEN level = 0 THEN grid.floor END) AS floor,
    MAX(CASE WHEN level = 0 THEN grid.floor_sd END) AS floor_sd,
    MAX(CASE WHEN level = 0 THEN grid.floor_max END) AS floor_max,
    CAST(
      MAX(
        CASE
          WHEN grid.vectors >= :least_vectors
            AND grid.floor - CAST(:target_floor AS DOUBLE) <= CAST(9.094947017729282e-13 AS DOUBLE)
            THEN level_bins
        END
      ) AS BIGINT
    ) AS finest_bins
  FROM floors AS grid
  GROUP BY asset, channel
) AS whole
JOIN bounds AS scale ON scale.asset = whole.asset AND scale.channel = whole.channel
JOIN (
  SELECT
    asset,
    channel,
    CAST(COUNT(*) AS BIGINT) AS cells,
    CAST(SUM(CASE WHEN visits = 1 THEN 1 ELSE 0 END) AS BIGINT) AS seen_once
  FROM support
  GROUP BY asset, channel
) AS held ON held.asset = whole.asset AND held.channel = whole.channel
