-- History: the samples, and which of them are of that period.
-- Reads:  samples, channels
-- Slots:  :healthy      whether a sample is of the healthy period
--         :settings_no  the number of the set
SELECT
  sampled.asset AS asset,
  sampled.channel AS channel,
  sampled.time AS time,
  sampled.value AS value,
  scale.first_scored AS first_scored,
  CASE WHEN :healthy THEN 1 ELSE 0 END AS calibrating
FROM samples AS sampled
JOIN channels AS scale ON scale.asset = sampled.asset AND scale.channel = sampled.channel
WHERE scale.settings_no = :settings_no
