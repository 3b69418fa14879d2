-- Support summary: what was learnt of each channel, and whether it is good enough to be watched
-- (method, section 5). Verdicts, in this order: no_data, constant, ready, too_fine, needs_data.
-- Reads:  channels, series, bounds, blocks, cells, spread, finest, outlook, missing_vectors
-- A row:  one channel, in order. What speaks of the support is the pool's. vectors_needed is in whole
--         windows; 2^-20 of one allows for the last bits of logarithms, which differ between engines.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  scale.lo AS lo,
  scale.hi AS hi,
  CAST(extent.samples AS BIGINT) AS samples,
  CAST(scale.calibration_samples AS BIGINT) AS calibration_samples,
  CAST(CASE WHEN own.hit = 1 THEN own.vectors ELSE 0 END AS BIGINT) AS calibration_vectors,
  CAST(CASE WHEN held.hit = 1 THEN held.cells ELSE 0 END AS BIGINT) AS cells,
  CAST(CASE WHEN incomplete.hit = 1 THEN incomplete.missing_vectors ELSE 0 END AS BIGINT)
    AS missing_vectors,
  CAST(extent.conflicts AS BIGINT) AS conflicts,
  CASE
    WHEN scale.lo IS NULL THEN 'no_data'
    WHEN whole.hit = 1
      THEN CASE
        WHEN scale.hi = scale.lo THEN 'constant'
        WHEN grid.hit = 1 AND grid.finest_bins = scale.bins THEN 'ready'
        WHEN grid.hit = 1 THEN 'too_fine'
        ELSE 'needs_data'
      END
    ELSE 'no_data'
  END AS verdict,
  CASE WHEN whole.hit = 1 THEN whole.floor END AS floor,
  CASE WHEN whole.hit = 1 THEN whole.floor_sd END AS floor_sd,
  CASE WHEN whole.hit = 1 THEN whole.floor_max END AS floor_max,
  CASE
    WHEN whole.hit = 1 AND held.hit = 1
      THEN CAST(held.seen_once AS DOUBLE) / CAST(whole.vectors AS DOUBLE)
  END AS good_turing,
  CASE
    WHEN whole.hit = 1 AND held.hit = 1
      THEN CAST(held.cells AS DOUBLE) / CAST(whole.vectors AS DOUBLE)
  END AS cells_per_vector,
  CAST(CASE WHEN whole.hit = 1 THEN whole.blocks ELSE 0 END AS BIGINT) AS blocks,
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
FROM channels AS named
JOIN series AS extent ON extent.channel_id = named.channel_id
JOIN bounds AS scale ON scale.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, CAST(SUM(part.vectors) AS BIGINT) AS vectors, 1 AS hit
  FROM blocks AS part
  GROUP BY channel_id
) AS own ON own.channel_id = named.channel_id
LEFT JOIN (
  SELECT
    support_id,
    CAST(COUNT(*) AS BIGINT) AS cells,
    CAST(SUM(CASE WHEN visits = 1 THEN 1 ELSE 0 END) AS BIGINT) AS seen_once,
    1 AS hit
  FROM cells
  GROUP BY support_id
) AS held ON held.support_id = named.support_id
LEFT JOIN (
  SELECT support_id, floor, floor_sd, floor_max, vectors, blocks, 1 AS hit
  FROM spread
) AS whole ON whole.support_id = named.support_id
LEFT JOIN (
  SELECT support_id, finest_bins, 1 AS hit
  FROM finest
) AS grid ON grid.support_id = named.support_id
LEFT JOIN (
  SELECT support_id, vectors, needed_total, 1 AS hit
  FROM outlook
) AS ahead ON ahead.support_id = named.support_id
LEFT JOIN (
  SELECT channel_id, missing_vectors, 1 AS hit
  FROM missing_vectors
) AS incomplete ON incomplete.channel_id = named.channel_id
ORDER BY named.asset, named.channel
