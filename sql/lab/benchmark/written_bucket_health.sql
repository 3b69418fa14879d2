-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Written bucket health: one program's result, in a form that can be compared.
SELECT
  asset,
  channel,
  CAST(bucket AS BIGINT) AS bucket,
  CAST(first_time AS BIGINT) AS first_time,
  CAST(last_time AS BIGINT) AS last_time,
  CAST(novel AS BIGINT) AS novel,
  CAST(out_of_range AS BIGINT) AS out_of_range,
  CAST(novel_in_window AS BIGINT) AS novel_in_window,
  CAST(hi AS DOUBLE) AS hi
FROM bucket_health
ORDER BY asset, channel, bucket
