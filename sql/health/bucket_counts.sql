-- Bucket counts: the window of Eq. 2 at bucket ends, as a difference of running counts over buckets.
-- Reads:  buckets
-- A row:  one bucket; novel_in_window is NULL until W vectors were scored.
-- Slots:  :buckets  W / stride, the buckets of a window
--         :window   W, in vectors
--         :differing  the column buckets where channels differ in it; none where all share them
SELECT
  channel_id,
  bucket_no,
  first_time,
  last_time,
  novel,
  out_of_range,
  CASE
    WHEN bucket_no >= :buckets THEN novel_so_far - novel_before
    WHEN bucket_no = :buckets - 1 THEN novel_so_far
  END AS novel_in_window,
  :window AS window_length
FROM (
  SELECT
    channel_id,
    bucket_no,
    first_time,
    last_time,
    novel,
    out_of_range,
    novel_so_far,
    :differing,
    LAG(novel_so_far, :buckets) OVER (PARTITION BY channel_id ORDER BY bucket_no) AS novel_before
  FROM (
    SELECT
      channel_id,
      bucket_no,
      first_time,
      last_time,
      novel,
      out_of_range,
      :differing,
      CAST(
        SUM(novel) OVER (
          PARTITION BY channel_id
          ORDER BY bucket_no
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS novel_so_far
    FROM buckets
  ) AS running
) AS lagged
