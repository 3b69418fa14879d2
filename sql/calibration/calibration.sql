-- Calibration: the closed intervals known to be healthy, resolved (method, section 4).
-- Reads:  limits, declared
-- A row:  one interval of one channel; the intervals of a channel are disjoint.
SELECT
  cut.channel_id AS channel_id,
  cut.time_from AS time_from,
  cut.time_to AS time_to
FROM (
  SELECT
    edge.channel_id AS channel_id,
    CASE
      WHEN piece.time_from < edge.calibration_from THEN edge.calibration_from
      ELSE piece.time_from
    END AS time_from,
    CASE
      WHEN piece.time_to > edge.calibration_end THEN edge.calibration_end
      ELSE piece.time_to
    END AS time_to
  FROM limits AS edge
  JOIN declared AS piece ON piece.calibration_no = edge.calibration_no
  WHERE edge.calibration_end IS NOT NULL
) AS cut
WHERE cut.time_from <= cut.time_to
