-- Breaks: a step in time larger than max_gap ends a segment (method, section 1); no vector spans two.
-- Reads:  samples, channels
-- A row:  the first sample of a segment, the first segment of a channel excepted.
-- Slots:  :settings_no  the set of parameters that this step serves
--         :max_gap      the longest step inside a segment, in the unit of time
SELECT ordered.channel_id AS channel_id, ordered.time AS time
FROM (
  SELECT
    sampled.channel_id AS channel_id,
    sampled.time AS time,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time) AS BIGINT
    ) AS position,
    LAG(sampled.time, 1) OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time)
      AS previous_time
  FROM samples AS sampled
  JOIN channels AS named ON named.channel_id = sampled.channel_id
  WHERE named.settings_no = :settings_no
) AS ordered
WHERE ordered.position > 1 AND ordered.time - ordered.previous_time > :max_gap
