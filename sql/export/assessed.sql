-- Assessed, dbt form: each channel with what it is judged by, and what its buckets say.
-- Reads:  certified, stored_bucket
-- A row:  one channel; hi is NULL until a window is scored. since_tick is the end of the first bucket of the unbroken
--         run above hi_limit that goes on, window_from_tick where the window of that bucket begins; NULL if below.
-- Slots:  :stride  vectors per bucket
SELECT
  learnt.channel_id AS channel_id,
  learnt.verdict AS verdict,
  learnt.hi_limit AS hi_limit,
  learnt.limit_reason AS limit_reason,
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
  CASE WHEN shown.hit = 1 THEN shown.last_time END AS last_tick,
  CASE WHEN shown.hit = 1 THEN shown.since_tick END AS since_tick,
  CASE WHEN shown.hit = 1 THEN shown.window_from_tick END AS window_from_tick
FROM certified AS learnt
LEFT JOIN (
  SELECT
    history.channel_id AS channel_id,
    1 AS hit,
    history.newest_no AS newest_no,
    CAST(COUNT(*) AS BIGINT) AS buckets,
    MAX(history.window_length) AS window_length,
    MAX(history.last_time) AS last_time,
    CAST(SUM(history.novel) AS BIGINT) AS novel,
    CAST(
      SUM(CASE WHEN history.vectors_back < history.window_length THEN history.out_of_range ELSE 0 END) AS BIGINT
    ) AS out_of_range,
    MAX(CASE WHEN history.vectors_back = 0 THEN history.novel_in_window END) AS novel_in_window,
    MAX(CASE WHEN history.vectors_back = history.window_length THEN history.novel_in_window END)
      AS novel_window_before,
    MAX(history.novel_in_window) AS most_in_window,
    MIN(CASE WHEN history.bucket_no > history.last_below THEN history.last_time END) AS since_tick,
    MIN(
      CASE
        WHEN history.newest_no > history.last_below
          AND (history.bucket_no - history.last_below - 1) * :stride + history.window_length > 0
          THEN history.first_time
      END
    ) AS window_from_tick
  FROM (
    SELECT
      above.channel_id AS channel_id,
      above.bucket_no AS bucket_no,
      MAX(above.bucket_no) OVER (PARTITION BY above.channel_id) AS newest_no,
      MAX(CASE WHEN above.is_above = 1 THEN -1 ELSE above.bucket_no END) OVER (PARTITION BY above.channel_id)
        AS last_below,
      (MAX(above.bucket_no) OVER (PARTITION BY above.channel_id) - above.bucket_no) * :stride AS vectors_back,
      above.window_length AS window_length,
      above.first_time AS first_time,
      above.last_time AS last_time,
      above.novel AS novel,
      above.out_of_range AS out_of_range,
      above.novel_in_window AS novel_in_window
    FROM (
      SELECT
        full_bucket.channel_id AS channel_id,
        full_bucket.bucket_no AS bucket_no,
        full_bucket.window_length AS window_length,
        full_bucket.first_time AS first_time,
        full_bucket.last_time AS last_time,
        full_bucket.novel AS novel,
        full_bucket.out_of_range AS out_of_range,
        full_bucket.novel_in_window AS novel_in_window,
        CASE
          WHEN CAST(full_bucket.novel_in_window AS DOUBLE) / CAST(full_bucket.window_length AS DOUBLE)
            > learnt.hi_limit
            THEN 1
          ELSE 0
        END AS is_above
      FROM stored_bucket AS full_bucket
      JOIN certified AS learnt ON learnt.channel_id = full_bucket.channel_id
      WHERE full_bucket.last_time IS NOT NULL
    ) AS above
  ) AS history
  GROUP BY history.channel_id, history.newest_no
) AS shown ON shown.channel_id = learnt.channel_id
