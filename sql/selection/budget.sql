-- Budget: what the certificate says of each m: the floor on the grid asked for, and the finest grid that
-- the calibration there is can fill (method, section 5).
-- Reads:  learners, verdicts, ladder
-- A row:  one dimension of one channel that has vectors of that length. vectors_needed is in whole
--         windows, as in support_summary.
SELECT
  learner.taught_id AS channel_id,
  learner.m AS m,
  judged.vectors AS vectors,
  judged.cells AS cells,
  judged.floor AS floor,
  judged.verdict AS verdict,
  judged.finest_bins AS finest_bins,
  CASE WHEN grid.hit = 1 THEN grid.finest_floor END AS finest_floor,
  judged.vectors_needed AS vectors_needed
FROM learners AS learner
JOIN verdicts AS judged ON judged.channel_id = learner.channel_id
LEFT JOIN (
  SELECT support_id, level_bins, floor AS finest_floor, 1 AS hit
  FROM ladder
) AS grid ON grid.support_id = learner.support_id AND grid.level_bins = judged.finest_bins
WHERE judged.vectors > 0
