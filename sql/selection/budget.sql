-- Budget: what the certificate says of each m: the floor on the grid asked for, and the finest grid that
-- the calibration there is can fill (method, section 5).
-- Reads:  learners, spread, cells, finest, ladder, outlook
-- A row:  one dimension of one channel that has vectors of that length. vectors_needed is in whole
--         windows, as in support_summary.
-- Slots:  :bins  B, the finest grid looked at
SELECT
  learner.taught_id AS channel_id,
  learner.m AS m,
  whole.vectors AS vectors,
  held.cells AS cells,
  whole.floor AS floor,
  CASE
    WHEN grid.hit = 1 AND grid.finest_bins = :bins THEN 'ready'
    WHEN grid.hit = 1 THEN 'too_fine'
    ELSE 'needs_data'
  END AS verdict,
  CAST(CASE WHEN grid.hit = 1 THEN grid.finest_bins END AS BIGINT) AS finest_bins,
  CASE WHEN grid.hit = 1 THEN grid.finest_floor END AS finest_floor,
  CAST(
    CASE
      WHEN grid.hit = 1 AND grid.finest_bins = :bins THEN 0
      WHEN further.hit = 1
        THEN 0 - learner.window_length * FLOOR(
          (CAST(whole.vectors AS DOUBLE) - further.needed_total)
          / CAST(learner.window_length AS DOUBLE)
          + CAST(1 AS DOUBLE) / CAST(1048576 AS DOUBLE)
        )
    END AS BIGINT
  ) AS vectors_needed
FROM learners AS learner
JOIN spread AS whole ON whole.support_id = learner.support_id
JOIN (
  SELECT support_id, CAST(COUNT(*) AS BIGINT) AS cells
  FROM cells
  GROUP BY support_id
) AS held ON held.support_id = whole.support_id
LEFT JOIN (
  SELECT
    best.support_id AS support_id,
    best.finest_bins AS finest_bins,
    step.floor AS finest_floor,
    1 AS hit
  FROM finest AS best
  JOIN ladder AS step
    ON step.support_id = best.support_id AND step.level_bins = best.finest_bins
) AS grid ON grid.support_id = whole.support_id
LEFT JOIN (
  SELECT support_id, needed_total, 1 AS hit
  FROM outlook
) AS further ON further.support_id = whole.support_id
