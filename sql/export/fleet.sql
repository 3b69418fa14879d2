-- Fleet: what is known of every channel now, one row each. A channel is above its limit where its verdict is
-- ready and hi is larger than hi_limit.
-- Reads:  stored_channel, stored_bounds, stored_bucket
-- A row:  one channel.
-- Slots:  :times         last_time as the source tells time; nothing where it counts
--         :window        W, in vectors
--         :stride        vectors per bucket
--         :target_floor  indicator that a healthy machine may show
SELECT
  known.asset AS asset,
  known.channel AS channel,
  learnt.verdict AS verdict,
  learnt.floor AS floor,
  learnt.floor_sd AS floor_sd,
  learnt.floor_max AS floor_max,
  CASE
    WHEN learnt.floor IS NULL OR learnt.floor_max IS NULL THEN NULL
    WHEN 2 * learnt.floor >= learnt.floor_max
      AND 2 * learnt.floor >= CAST(:target_floor AS DOUBLE)
      THEN 2 * learnt.floor
    WHEN learnt.floor_max >= CAST(:target_floor AS DOUBLE) THEN learnt.floor_max
    ELSE CAST(:target_floor AS DOUBLE)
  END AS hi_limit,
  CASE
    WHEN made.hit = 1 AND made.novel_in_window IS NOT NULL
      THEN CAST(made.novel_in_window AS DOUBLE) / CAST(made.window_length AS DOUBLE)
  END AS hi,
  CASE
    WHEN made.hit = 1 AND made.most_in_window IS NOT NULL
      THEN CAST(made.most_in_window AS DOUBLE) / CAST(made.window_length AS DOUBLE)
  END AS hi_highest,
  CASE WHEN made.hit = 1 THEN made.novel_in_window END AS novel_in_window,
  CASE WHEN made.hit = 1 THEN made.novel_window_before END AS novel_window_before,
  CASE WHEN made.hit = 1 THEN made.out_of_range END AS out_of_range_in_window,
  CAST(:window AS BIGINT) AS window_length,
  CASE WHEN made.hit = 1 THEN made.newest_no END AS bucket,
  CASE WHEN made.hit = 1 THEN made.buckets ELSE 0 END AS buckets,
  CASE WHEN made.hit = 1 THEN made.novel ELSE 0 END AS novel_in_buckets,
  :times,
  CASE WHEN made.hit = 1 THEN made.last_time END AS last_tick,
  learnt.calibration_vectors AS calibration_vectors,
  learnt.cells AS cells,
  learnt.lo AS calibrated_lo,
  learnt.hi AS calibrated_hi,
  learnt.finest_bins AS finest_bins,
  learnt.vectors_needed AS vectors_needed
FROM stored_channel AS known
JOIN stored_bounds AS learnt ON learnt.support_id = known.support_id
LEFT JOIN (
  SELECT
    placed.channel_id AS channel_id,
    1 AS hit,
    placed.newest_no AS newest_no,
    CAST(COUNT(*) AS BIGINT) AS buckets,
    MAX(placed.window_length) AS window_length,
    MAX(placed.last_time) AS last_time,
    CAST(SUM(placed.novel) AS BIGINT) AS novel,
    CAST(
      SUM(CASE WHEN placed.vectors_back < placed.window_length THEN placed.out_of_range ELSE 0 END) AS BIGINT
    ) AS out_of_range,
    MAX(CASE WHEN placed.vectors_back = 0 THEN placed.novel_in_window END) AS novel_in_window,
    MAX(CASE WHEN placed.vectors_back = placed.window_length THEN placed.novel_in_window END)
      AS novel_window_before,
    MAX(placed.novel_in_window) AS most_in_window
  FROM (
    SELECT
      full_bucket.channel_id AS channel_id,
      newest.newest_no AS newest_no,
      (newest.newest_no - full_bucket.bucket_no) * :stride AS vectors_back,
      full_bucket.window_length AS window_length,
      full_bucket.last_time AS last_time,
      full_bucket.novel AS novel,
      full_bucket.out_of_range AS out_of_range,
      full_bucket.novel_in_window AS novel_in_window
    FROM stored_bucket AS full_bucket
    JOIN (
      SELECT channel_id, MAX(bucket_no) AS newest_no
      FROM stored_bucket
      WHERE last_time IS NOT NULL
      GROUP BY channel_id
    ) AS newest ON newest.channel_id = full_bucket.channel_id
    WHERE full_bucket.last_time IS NOT NULL
  ) AS placed
  GROUP BY placed.channel_id, placed.newest_no
) AS made ON made.channel_id = known.channel_id
