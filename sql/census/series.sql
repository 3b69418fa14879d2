-- Series: each channel's samples in figures; as source/series.sql, by the census.
-- Reads:  edges, edge_samples, conflicts
-- A row:  one channel; quota_time is the time of its floor(fraction * n)-th sample, if calibration
--         is by fraction and that is at least one sample.
SELECT
  counted.channel_id AS channel_id,
  counted.samples AS samples,
  clashes.conflicts AS conflicts,
  counted.first_time AS first_time,
  CASE WHEN reached.hit = 1 THEN reached.time END AS quota_time
FROM (
  SELECT
    channel_id,
    CAST(SUM(part.samples) AS BIGINT) AS samples,
    MIN(part.first_time) AS first_time,
    MAX(part.quota) AS quota
  FROM edges AS part
  GROUP BY channel_id
) AS counted
JOIN conflicts AS clashes ON clashes.channel_id = counted.channel_id
LEFT JOIN (
  SELECT channel_id, place, time, 1 AS hit
  FROM edge_samples
) AS reached ON reached.channel_id = counted.channel_id AND reached.place = counted.quota
