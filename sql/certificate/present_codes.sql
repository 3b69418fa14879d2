-- Present codes: which samples are there, of channels that may have vectors with a missing sample: 1, and 0 where one
-- is missing. The vectors of these codes tell how many contain a missing sample, wherever calibration ends.
-- Reads:  samples, channels
-- A row:  one sample.
-- Slots:  :settings_no  the set of parameters that this step serves
--         :read         which channels these are
--         :carried      columns that travel with the sample
SELECT
  sampled.channel_id AS channel_id,
  sampled.time AS time,
  CAST(CASE WHEN sampled.value IS NULL THEN 0 ELSE 1 END AS SMALLINT) AS code,
  :carried
FROM samples AS sampled
JOIN channels AS named ON named.channel_id = sampled.channel_id
WHERE named.settings_no = :settings_no AND :read
