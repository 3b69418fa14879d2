-- Known codes: of channels that may have vectors with a missing sample, which ones are there: 1, and 0 where one is
-- missing. The vectors of these codes tell how many contain one, wherever calibration ends.
-- Reads:  identified, channels
-- A row:  one sample.
-- Slots:  :settings_no  the set of parameters that this step serves
--         :read         which channels these are
--         :carried      columns that travel with the sample
SELECT
  reading.channel_id AS channel_id,
  reading.time AS time,
  CAST(CASE WHEN reading.value IS NULL THEN 0 ELSE 1 END AS SMALLINT) AS code,
  :carried
FROM identified AS reading
JOIN channels AS named ON named.channel_id = reading.channel_id
WHERE named.settings_no = :settings_no AND :read
