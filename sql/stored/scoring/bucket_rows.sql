-- Bucket rows: what a run appends to the stored buckets, with the two integers of Eq. 2.
-- Reads:  written, bucket_counts, still_counts, stamp
-- A row:  one bucket; still is NULL where no sample counts as still.
SELECT
  made.version_id AS version_id,
  made.bucket_no AS bucket_no,
  stamp.run_id AS run_id,
  made.first_time AS first_time,
  made.last_time AS last_time,
  made.context_time AS context_time,
  made.samples AS samples,
  CASE WHEN calm.hit = 1 THEN calm.still END AS still,
  made.novel AS novel,
  made.out_of_range AS out_of_range,
  counted.novel_in_window AS novel_in_window
FROM written AS made
JOIN bucket_counts AS counted
  ON counted.channel_id = made.channel_id AND counted.bucket_no = made.bucket_no
LEFT JOIN (
  SELECT channel_id, bucket_no, still, 1 AS hit
  FROM still_counts
) AS calm ON calm.channel_id = made.channel_id AND calm.bucket_no = made.bucket_no
CROSS JOIN stamp
ORDER BY made.version_id, made.bucket_no
