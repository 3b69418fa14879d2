-- Health, made again: the indicator at the end of every full bucket, now with its limit beside it, which is that of
-- sql/judgement/hi_limit.sql, word for word. Filters reach the stored rows as before.
CREATE OR REPLACE VIEW stored_health AS
SELECT
  watching.name AS monitor,
  named.asset AS asset,
  named.channel AS channel,
  version.version_no AS version_no,
  full_bucket.bucket_no AS bucket,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(full_bucket.first_time) END
    AS first_time,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(full_bucket.last_time) END
    AS last_time,
  full_bucket.first_time AS first_tick,
  full_bucket.last_time AS last_tick,
  full_bucket.samples AS samples,
  full_bucket.novel AS novel,
  full_bucket.out_of_range AS out_of_range,
  full_bucket.novel_in_window AS novel_in_window,
  version.window_length AS window_length,
  CASE
    WHEN full_bucket.novel_in_window IS NOT NULL
      THEN CAST(full_bucket.novel_in_window AS DOUBLE) / CAST(version.window_length AS DOUBLE)
  END AS hi,
  learnt.verdict AS verdict,
  CASE
    WHEN learnt.verdict <> 'ready' OR learnt.floor IS NULL OR learnt.floor_max IS NULL THEN NULL
    WHEN 2 * learnt.floor >= learnt.floor_max AND 2 * learnt.floor >= version.target_floor
      THEN 2 * learnt.floor
    WHEN learnt.floor_max >= version.target_floor THEN learnt.floor_max
    ELSE version.target_floor
  END AS hi_limit
FROM stored_visible_bucket AS full_bucket
JOIN stored_version AS version ON version.version_id = full_bucket.version_id
JOIN stored_bounds AS learnt ON learnt.support_id = version.support_id
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS active ON active.newest_id = version.version_id
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id;

COMMENT ON VIEW stored_health
  IS 'Health indicator at the end of every full bucket of scored vectors, active versions only';
COMMENT ON COLUMN stored_health.monitor IS 'The monitor';
COMMENT ON COLUMN stored_health.asset IS 'The machine';
COMMENT ON COLUMN stored_health.channel IS 'The signal';
COMMENT ON COLUMN stored_health.version_no IS 'Which calibration of the channel: 1, 2, ...';
COMMENT ON COLUMN stored_health.bucket
  IS 'Number of the bucket: (number of a scored vector - 1) div stride';
COMMENT ON COLUMN stored_health.first_time
  IS 'Time of its first vector (UTC); NULL where the source counts time, see first_tick';
COMMENT ON COLUMN stored_health.last_time
  IS 'Time of its last vector (UTC); NULL where the source counts time, see last_tick';
COMMENT ON COLUMN stored_health.first_tick
  IS 'Time of its first vector: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_health.last_tick
  IS 'Time of its last vector: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_health.samples
  IS 'Samples after the previous bucket up to the end of this one, missing ones included';
COMMENT ON COLUMN stored_health.novel IS 'Vectors in the bucket whose cell is not in the support';
COMMENT ON COLUMN stored_health.out_of_range
  IS 'Vectors in the bucket with a sample outside the range of calibration; all of them are novel';
COMMENT ON COLUMN stored_health.novel_in_window
  IS 'Novel vectors in the window that ends with the bucket; NULL until the window is full';
COMMENT ON COLUMN stored_health.window_length IS 'Scored vectors in a window';
COMMENT ON COLUMN stored_health.hi
  IS 'Health indicator: novel_in_window / window_length, 0 like calibration, 1 all states never seen';
COMMENT ON COLUMN stored_health.verdict
  IS 'Is the calibration good enough? ready, too_fine, needs_data, constant or no_data';
COMMENT ON COLUMN stored_health.hi_limit IS 'Where hi is high; NULL where nothing is to be judged';
