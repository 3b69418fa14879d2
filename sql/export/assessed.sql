-- Assessed, dbt form: each channel with what it is judged by, and what its buckets say.
-- Reads:  stored_channel, stored_bounds, stored_bucket
-- A row:  one channel; hi is NULL until a window is scored.
-- Slots:  :hi_limit, :limit_reason  the expressions of judgement/hi_limit.sql and judgement/limit_reason.sql
--         :stride                   vectors per bucket
SELECT
  known.channel_id AS channel_id,
  learnt.verdict AS verdict,
  :hi_limit AS hi_limit,
  :limit_reason AS limit_reason,
  CASE
    WHEN shown.hit = 1 AND shown.novel_in_window IS NOT NULL
      THEN CAST(shown.novel_in_window AS DOUBLE) / CAST(shown.window_length AS DOUBLE)
  END AS hi,
  CASE
    WHEN shown.hit = 1 AND shown.most_in_window IS NOT NULL
      THEN CAST(shown.most_in_window AS DOUBLE) / CAST(shown.window_length AS DOUBLE)
  END AS hi_highest,
  CASE WHEN shown.hit = 1 THEN shown.novel_in_window END AS novel_in_window,
  CASE WHEN shown.hit = 1 THEN shown.novel_window_before END AS novel_window_before,
  CASE WHEN shown.hit = 1 THEN shown.out_of_range END AS out_of_range_in_window,
  CASE WHEN shown.hit = 1 THEN shown.newest_no END AS bucket,
  CASE WHEN shown.hit = 1 THEN shown.buckets ELSE 0 END AS buckets,
  CASE WHEN shown.hit = 1 THEN shown.novel ELSE 0 END AS novel_in_buckets,
  CASE WHEN shown.hit = 1 THEN shown.last_time END AS last_tick
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
) AS shown ON shown.channel_id = known.channel_id
