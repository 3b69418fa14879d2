-- Timeline: one look at the times alone. Does an instant occur twice, and when was the calibration
-- quota of readings reached? A source without repeated instants pays for nothing more.
-- Reads:  identified, channels, rules
-- A row:  one channel; quota_time is right only where repeats = 0 (else see recounted).
SELECT
  ordered.channel_id AS channel_id,
  CAST(
    SUM(CASE WHEN ordered.position > 1 AND ordered.time = ordered.previous_time THEN 1 ELSE 0 END)
    AS BIGINT
  ) AS repeats,
  MIN(ordered.time) AS first_time,
  MAX(
    CASE
      WHEN ordered.position
        = CAST(FLOOR(chosen_rule.fraction * CAST(named.readings AS DOUBLE)) AS BIGINT) THEN ordered.time
    END
  ) AS quota_time
FROM (
  SELECT
    reading.channel_id AS channel_id,
    reading.time AS time,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY reading.channel_id ORDER BY reading.time) AS BIGINT
    ) AS position,
    LAG(reading.time, 1) OVER (PARTITION BY reading.channel_id ORDER BY reading.time)
      AS previous_time
  FROM identified AS reading
) AS ordered
JOIN channels AS named ON named.channel_id = ordered.channel_id
JOIN rules AS chosen_rule ON chosen_rule.calibration_no = named.calibration_no
GROUP BY ordered.channel_id
