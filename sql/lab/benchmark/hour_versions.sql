-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Hour, versions: the channels in order, their range, and the bucket after the last that stays.
-- Slots:  :lookback  microseconds
SELECT
  version.version_id,
  named.asset,
  named.channel,
  version.support_id,
  learnt.calibrated_lo,
  learnt.calibrated_hi,
  staying.bucket_no + 1 AS first_bucket,
  staying.context_time,
  staying.last_time
FROM gam_state_version AS version
JOIN gam_state_channel AS named ON named.channel_id = version.channel_id
JOIN gam_state_bounds AS learnt ON learnt.support_id = version.support_id
JOIN (
  SELECT
    version_id,
    MAX(bucket_no) AS bucket_no,
    MAX(context_time) AS context_time,
    MAX(last_time) AS last_time
  FROM (
    SELECT *, MAX(last_time) OVER (PARTITION BY version_id) AS newest_time
    FROM gam_state_bucket
  ) AS dated
  WHERE last_time < newest_time - :lookback
  GROUP BY version_id
) AS staying ON staying.version_id = version.version_id
ORDER BY named.asset, named.channel
