-- Channel rows: the channels that the source held when the package was first built, each with what is frozen
-- then: its number, its support, and when calibration ends. A channel that appears later is scored after a
-- full refresh.
-- Reads:  channels, limits, run_up, recount
-- A row:  one channel. run_up_from reaches back so many samples before the first vector to be scored, or
--         over everything where there are not that many.
-- Slots:  :span           (m-1) * tau, and still_after - 1 more where still samples are told by those before
--         :long_ago       an instant before all others
--         :settings_hash  of the settings of the package
--         :method_hash    of the SQL that learns
SELECT
  CAST(named.channel_id AS BIGINT) AS channel_id,
  CAST(named.support_id AS BIGINT) AS support_id,
  named.asset AS asset,
  named.channel AS channel,
  CAST(named.calibration_no AS BIGINT) AS calibration_no,
  edge.calibration_end AS calibration_end,
  edge.first_scored AS first_scored,
  CASE
    WHEN earlier.hit = 1 THEN earlier.run_up_from
    WHEN :span = 0 THEN edge.first_scored
    ELSE CAST(:long_ago AS BIGINT)
  END AS run_up_from,
  CASE WHEN counted.hit = 1 THEN counted.calibration_readings ELSE 0 END AS calibration_readings,
  :settings_hash AS settings_hash,
  :method_hash AS method_hash
FROM channels AS named
JOIN limits AS edge ON edge.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, run_up_from, 1 AS hit
  FROM run_up
) AS earlier ON earlier.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, calibration_readings, 1 AS hit
  FROM recount
) AS counted ON counted.channel_id = named.channel_id
