-- Channels: each signal of each machine, and the period in which it is known to be healthy.
-- Reads:  samples
-- Slots:  :settings_no       the number of the set
--         :calibration_from  when that period begins
--         :calibration_end   when it ends
--         :first_scored      from when on vectors are scored
--         :quota             the number of the last sample of the healthy share
SELECT
  asset,
  channel,
  samples,
  conflicts,
  :settings_no AS settings_no,
  :calibration_from AS calibration_from,
  :calibration_end AS calibration_end,
  :first_scored AS first_scored
FROM (
  SELECT
    asset,
    channel,
    CAST(COUNT(*) AS BIGINT) AS samples,
    CAST(SUM(conflict) AS BIGINT) AS conflicts,
    MIN(time) AS first_time,
    MAX(CASE WHEN position = :quota THEN time END) AS quota_time
  FROM (
    SELECT
      asset,
      channel,
      time,
      conflict,
      CAST(ROW_NUMBER() OVER (PARTITION BY asset, channel ORDER BY time) AS BIGINT) AS position,
      CAST(COUNT(*) OVER (PARTITION BY asset, channel) AS BIGINT) AS series_length
    FROM samples
  ) AS ordered
  GROUP BY asset, channel
) AS counted
