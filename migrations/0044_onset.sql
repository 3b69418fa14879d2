-- Onset: since when the indicator of each version is above its limit without a break, over the buckets that are
-- kept, and how long its buckets take. The limit is that of sql/judgement/hi_limit.sql, word for word.
CREATE OR REPLACE VIEW stored_onset AS
SELECT
  placed.version_id AS version_id,
  CAST(COUNT(*) AS BIGINT) AS buckets,
  MIN(placed.first_time) AS first_tick,
  MAX(placed.last_time) AS last_tick,
  MAX(placed.since_bucket) AS since_bucket,
  MAX(CASE WHEN placed.bucket_no = placed.since_bucket THEN placed.last_time END) AS since_tick,
  MIN(
    CASE WHEN placed.bucket_no > placed.since_bucket - placed.in_window THEN placed.first_time END
  ) AS window_from_tick,
  MAX(
    CASE
      WHEN placed.bucket_no = placed.since_bucket AND placed.since_bucket > placed.last_below + 1 THEN 1
      WHEN placed.bucket_no = placed.since_bucket THEN 0
    END
  ) AS at_least
FROM (
  SELECT
    version_id,
    bucket_no,
    first_time,
    last_time,
    in_window,
    last_below,
    MIN(CASE WHEN bucket_no > last_below THEN bucket_no END) OVER (PARTITION BY version_id)
      AS since_bucket
  FROM (
    SELECT
      version_id,
      bucket_no,
      first_time,
      last_time,
      in_window,
      MAX(CASE WHEN is_above = 1 THEN -1 ELSE bucket_no END) OVER (PARTITION BY version_id) AS last_below
    FROM (
      SELECT
        full_bucket.version_id AS version_id,
        full_bucket.bucket_no AS bucket_no,
        full_bucket.first_time AS first_time,
        full_bucket.last_time AS last_time,
        CAST(version.window_length AS DOUBLE) / CAST(version.stride AS DOUBLE) AS in_window,
        CASE
          WHEN full_bucket.novel_in_window IS NULL OR version.hi_limit IS NULL THEN 0
          WHEN CAST(full_bucket.novel_in_window AS DOUBLE) / CAST(version.window_length AS DOUBLE)
            > version.hi_limit THEN 1
          ELSE 0
        END AS is_above
      FROM stored_visible_bucket AS full_bucket
      JOIN (
        SELECT
          version.version_id AS version_id,
          version.window_length AS window_length,
          version.stride AS stride,
          CASE
          WHEN learnt.verdict <> 'ready' OR learnt.floor IS NULL OR learnt.floor_max IS NULL THEN NULL
          WHEN 2 * learnt.floor >= learnt.floor_max AND 2 * learnt.floor >= version.target_floor
            THEN 2 * learnt.floor
          WHEN learnt.floor_max >= version.target_floor THEN learnt.floor_max
          ELSE version.target_floor
        END AS hi_limit
        FROM stored_version AS version
        JOIN stored_bounds AS learnt ON learnt.support_id = version.support_id
      ) AS version ON version.version_id = full_bucket.version_id
    ) AS compared
  ) AS bounded
) AS placed
GROUP BY placed.version_id;

COMMENT ON VIEW stored_onset
  IS 'Since when each version is above its limit, over the buckets that are kept; one row per version';
COMMENT ON COLUMN stored_onset.version_id IS 'The version';
COMMENT ON COLUMN stored_onset.buckets IS 'Buckets that are kept';
COMMENT ON COLUMN stored_onset.first_tick IS 'Time of the first vector of the oldest of them';
COMMENT ON COLUMN stored_onset.last_tick IS 'Time of the last vector of the newest of them';
COMMENT ON COLUMN stored_onset.since_bucket
  IS 'First bucket of the unbroken run above the limit that lasts to the newest; NULL if that is not above';
COMMENT ON COLUMN stored_onset.since_tick IS 'Time of the last vector of that bucket';
COMMENT ON COLUMN stored_onset.window_from_tick
  IS 'Time of the first vector of the window that ends with it, as far as its buckets are kept';
COMMENT ON COLUMN stored_onset.at_least
  IS '1 if the bucket before is no longer kept, so that the run may be longer; else 0; NULL if not above';
