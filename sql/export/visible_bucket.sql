-- Visible bucket, dbt form: the buckets that are there from the last build.
-- Reads:  stored_bucket
-- A row:  one bucket; a row without times marks one that is no more, until it is deleted.
SELECT
  made.channel_id AS version_id,
  made.bucket_no AS bucket_no,
  made.first_time AS first_time,
  made.last_time AS last_time,
  made.context_time AS context_time,
  made.novel AS novel,
  made.out_of_range AS out_of_range
FROM stored_bucket AS made
WHERE made.last_time IS NOT NULL
