-- Limit channels: the active versions of a monitor that limits can be made of, with what calibration says of them.
-- Channels of the same parameters have the same settings_no, whatever calibration chose by itself; target_floor counts in units of 2^-30, since BigQuery
-- groups by no double. Judgements counts the full windows there are.
-- Reads:  active, stored_version, stored_bounds, stored_extent, stored_block,
--         stored_limit, stored_visible_bucket
-- A row:  one active version; limit_no is that of its newest limit, 0 before there is one.
-- Slots:  :finds_tau, :finds_bins  1 where calibration chooses the delay of a channel (with it the dimension), or its bins
--         :hi_limit, :limit_reason  the expressions of judgement/hi_limit.sql and judgement/limit_reason.sql
--         :heeding       1 where a false alarm right after calibration leaves a version without a limit
SELECT
  member.channel_id AS channel_id,
  member.version_id AS version_id,
  member.asset AS asset,
  member.channel AS channel,
  member.window_length AS window_length,
  MIN(member.version_id) OVER (
    PARTITION BY
      CASE WHEN :finds_tau = 1 THEN 0 ELSE member.m END,
      CASE WHEN :finds_tau = 1 THEN 0 ELSE member.tau END,
      CASE WHEN :finds_bins = 1 THEN 0 ELSE member.bins END,
      member.window_length,
      member.stride,
      member.max_gap,
      version.still_after,
      CAST(FLOOR(version.target_floor * CAST(1073741824 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT)
  ) AS settings_no,
  CASE
    WHEN :heeding = 1 AND latest_limit.hit = 1 AND latest_limit.is_off = 1 THEN 'unrepresentative'
    ELSE :limit_reason
  END AS limit_reason,
  :hi_limit AS hi_limit,
  extent.vectors AS vectors,
  extent.calibration_length AS length,
  extent.order_ratio AS order_ratio,
  CASE WHEN latest_limit.hit = 1 THEN latest_limit.limit_no ELSE 0 END AS limit_no,
  CASE
    WHEN scored.hit = 1 THEN CAST(
      FLOOR(
        (CAST((scored.newest_no + 1) * member.stride AS DOUBLE) + CAST(5e-1 AS DOUBLE))
        / CAST(member.window_length AS DOUBLE)
      ) AS BIGINT
    )
    ELSE 0
  END AS judgements
FROM active AS member
JOIN stored_version AS version ON version.version_id = member.version_id
JOIN stored_extent AS extent ON extent.version_id = member.version_id
JOIN (
  SELECT
    version.version_id AS version_id,
    version.target_floor AS target_floor,
    CASE WHEN taught.hit = 1 OR scale.member_verdict IS NULL THEN scale.verdict ELSE scale.member_verdict END AS verdict,
    CASE WHEN taught.hit = 1 OR scale.member_verdict IS NULL THEN scale.floor ELSE scale.member_floor END AS floor,
    CASE WHEN taught.hit = 1 OR scale.member_verdict IS NULL THEN scale.floor_max ELSE scale.member_floor_max END
      AS floor_max
  FROM stored_version AS version
  JOIN stored_bounds AS scale ON scale.support_id = version.support_id
  LEFT JOIN (
    SELECT support_id, channel_id, 1 AS hit
    FROM stored_block
    GROUP BY support_id, channel_id
  ) AS taught ON taught.support_id = version.support_id AND taught.channel_id = version.channel_id
) AS learnt ON learnt.version_id = member.version_id
LEFT JOIN (
  SELECT
    version_id,
    MAX(limit_row.limit_no) AS limit_no,
    MAX(CASE WHEN limit_row.cause = 'false_alarm' THEN 1 ELSE 0 END) AS is_off,
    1 AS hit
  FROM stored_limit AS limit_row
  GROUP BY version_id
) AS latest_limit ON latest_limit.version_id = member.version_id
LEFT JOIN (
  SELECT version_id, MAX(bucket_no) AS newest_no, 1 AS hit
  FROM stored_visible_bucket
  GROUP BY version_id
) AS scored ON scored.version_id = member.version_id
