-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Stored buckets: what a monitor has stored, in the form of the exact result.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  bucket.bucket_no AS bucket,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.novel AS novel,
  bucket.out_of_range AS out_of_range,
  bucket.novel_in_window AS novel_in_window
FROM gam_state_visible_bucket AS bucket
JOIN gam_state_version AS frozen ON frozen.version_id = bucket.version_id
JOIN gam_state_channel AS named ON named.channel_id = frozen.channel_id
ORDER BY named.asset, named.channel, bucket.bucket_no
