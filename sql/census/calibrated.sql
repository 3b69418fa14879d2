-- Calibrated: the range of each channel's calibration samples; as calibration/calibrated.sql, by the census:
-- whole slices, and the samples of the edges.
-- Reads:  edges, edge_samples, calibration
-- A row:  one channel that has at least one calibration sample.
SELECT
  channel_id,
  MIN(part.lowest) AS lowest,
  MAX(part.highest) AS highest,
  CAST(SUM(part.samples) AS BIGINT) AS calibration_samples
FROM (
  SELECT
    whole.channel_id AS channel_id,
    whole.lowest AS lowest,
    whole.highest AS highest,
    whole.samples AS samples
  FROM edges AS whole
  JOIN calibration AS piece ON piece.channel_id = whole.channel_id
  WHERE whole.is_edge = 0 AND whole.last_time BETWEEN piece.time_from AND piece.time_to
  UNION ALL
  SELECT
    sampled.channel_id AS channel_id,
    sampled.value AS lowest,
    sampled.value AS highest,
    CAST(1 AS BIGINT) AS samples
  FROM edge_samples AS sampled
  JOIN calibration AS piece ON piece.channel_id = sampled.channel_id
  WHERE sampled.time BETWEEN piece.time_from AND piece.time_to
) AS part
GROUP BY channel_id
