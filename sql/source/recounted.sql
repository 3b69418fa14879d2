-- Recounted: the timeline of channels with repeated instants, after these have collapsed.
-- Reads:  samples, channels, timeline, rules
-- A row:  one such channel.
SELECT
  ordered.channel_id AS channel_id,
  CAST(COUNT(*) AS BIGINT) AS samples,
  CAST(SUM(ordered.conflict) AS BIGINT) AS conflicts,
  MAX(
    CASE
      WHEN ordered.position
        = CAST(FLOOR(chosen_rule.fraction * CAST(ordered.series_length AS DOUBLE)) AS BIGINT)
        THEN ordered.time
    END
  ) AS quota_time
FROM (
  SELECT
    sampled.channel_id AS channel_id,
    sampled.time AS time,
    sampled.conflict AS conflict,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time) AS BIGINT
    ) AS position,
    CAST(COUNT(*) OVER (PARTITION BY sampled.channel_id) AS BIGINT) AS series_length
  FROM samples AS sampled
  JOIN timeline AS dirty ON dirty.channel_id = sampled.channel_id
  WHERE dirty.repeats > 0
) AS ordered
JOIN channels AS named ON named.channel_id = ordered.channel_id
JOIN rules AS chosen_rule ON chosen_rule.calibration_no = named.calibration_no
GROUP BY ordered.channel_id
