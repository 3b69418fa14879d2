-- Moving z-score, as an indicator with a limit: a reading is odd if it is more than three standard deviations
-- from the mean of the window_length readings before it. The indicator is the share of odd readings in the
-- newest window_length, at the instants of gam_health. Its limit is made as that of gam-db: twice the share
-- of odd readings in calibration, its highest block, or 0.05, whichever is largest.
-- Reads:  reading (asset, channel, time, value), gam_health, gam_state_version, gam_state_channel,
--         gam_state_calibration
WITH channels AS (
  SELECT asset, channel, version_id, support_id, window_length
  FROM gam_state_version
  JOIN gam_state_channel USING (channel_id)
), scored AS (
  SELECT
    asset,
    channel,
    support_id,
    window_length,
    time,
    ROW_NUMBER() OVER (PARTITION BY asset, channel ORDER BY time) AS number,
    ABS(value - AVG(value) OVER before) > 3 * STDDEV_POP(value) OVER before AS is_odd
  FROM reading
  JOIN channels USING (asset, channel)
  WINDOW before AS (
    PARTITION BY asset, channel ORDER BY time ROWS BETWEEN window_length PRECEDING AND 1 PRECEDING
  )
), learnt AS (
  SELECT scored.support_id, scored.asset, number // scored.window_length AS block, is_odd
  FROM scored
  JOIN channels USING (asset, channel)
  WHERE EXISTS (
    FROM gam_state_calibration AS healthy
    WHERE healthy.version_id = channels.version_id AND time BETWEEN time_from AND time_to
  )
), blocks AS (
  SELECT support_id, SUM(is_odd::INT) AS odd, COUNT(*) AS readings
  FROM learnt
  GROUP BY support_id, asset, block
), limits AS (
  SELECT
    support_id,
    GREATEST(2 * SUM(odd) / SUM(readings), MAX(odd / readings) FILTER (readings >= 50), 0.05) AS hi_limit
  FROM blocks
  GROUP BY support_id
), indicator AS (
  SELECT
    asset,
    channel,
    support_id,
    time,
    AVG(is_odd::INT) OVER (
      PARTITION BY asset, channel ORDER BY time ROWS BETWEEN window_length - 1 PRECEDING AND CURRENT ROW
    ) AS hi
  FROM scored
)
SELECT asset, channel, bucket, last_time, last_tick, indicator.hi, limits.hi_limit
FROM indicator
JOIN limits USING (support_id)
JOIN gam_health USING (asset, channel)
WHERE time = last_tick AND gam_health.hi IS NOT NULL
