-- Verdicts: is the calibration good enough to be watched (method, section 5)? In this order: no_data,
-- constant, needs_data (of a support with few vectors, which has no finest grid), ready, too_fine, needs_data.
-- Reads:  bounds, cells, spread, finest, outlook
-- A row:  one channel; all but the range is that of its support. vectors_needed is in whole windows; 2^-20 of
--         one allows for the last bits of logarithms, which differ between engines.
SELECT
  scale.channel_id AS channel_id,
  CASE
    WHEN scale.calibrated_lo IS NULL THEN 'no_data'
    WHEN whole.hit = 1
      THEN CASE
        WHEN scale.calibrated_hi = scale.calibrated_lo THEN 'constant'
        WHEN grid.hit = 1 AND grid.finest_bins = scale.bins THEN 'ready'
        WHEN grid.hit = 1 THEN 'too_fine'
        ELSE 'needs_data'
      END
    ELSE 'no_data'
  END AS verdict,
  CAST(CASE WHEN whole.hit = 1 THEN whole.vectors ELSE 0 END AS BIGINT) AS vectors,
  CAST(CASE WHEN held.hit = 1 THEN held.cells ELSE 0 END AS BIGINT) AS cells,
  CAST(CASE WHEN held.hit = 1 THEN held.seen_once ELSE 0 END AS BIGINT) AS seen_once,
  CAST(CASE WHEN whole.hit = 1 THEN whole.blocks ELSE 0 END AS BIGINT) AS blocks,
  CASE WHEN whole.hit = 1 THEN whole.floor END AS floor,
  CASE WHEN whole.hit = 1 THEN whole.floor_sd END AS floor_sd,
  CASE WHEN whole.hit = 1 THEN whole.floor_max END AS floor_max,
  CAST(CASE WHEN grid.hit = 1 THEN grid.finest_bins END AS BIGINT) AS finest_bins,
  CAST(
    CASE
      WHEN grid.hit = 1 AND grid.finest_bins = scale.bins THEN 0
      WHEN ahead.hit = 1
        THEN 0 - scale.window_length * FLOOR(
          (CAST(ahead.vectors AS DOUBLE) - ahead.needed_total) / CAST(scale.window_length AS DOUBLE)
          + CAST(1 AS DOUBLE) / CAST(1048576 AS DOUBLE)
        )
    END AS BIGINT
  ) AS vectors_needed
FROM bounds AS scale
LEFT JOIN (
  SELECT
    support_id,
    CAST(COUNT(*) AS BIGINT) AS cells,
    CAST(SUM(CASE WHEN visits = 1 THEN 1 ELSE 0 END) AS BIGINT) AS seen_once,
    1 AS hit
  FROM cells
  GROUP BY support_id
) AS held ON held.support_id = scale.support_id
LEFT JOIN (
  SELECT support_id, floor, floor_sd, floor_max, vectors, blocks, 1 AS hit
  FROM spread
) AS whole ON whole.support_id = scale.support_id
LEFT JOIN (
  SELECT support_id, finest_bins, 1 AS hit
  FROM finest
) AS grid ON grid.support_id = scale.support_id
LEFT JOIN (
  SELECT support_id, vectors, needed_total, 1 AS hit
  FROM outlook
) AS ahead ON ahead.support_id = scale.support_id
