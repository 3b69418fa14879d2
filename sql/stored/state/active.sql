-- Active: the version by which each channel of a monitor is scored now, the newest one, with all that
-- scoring must know of it (method, section 1).
-- Reads:  stored_version, stored_channel, stored_bounds
-- A row:  one version.
-- Slots:  :monitor_id
SELECT
  frozen.version_id AS version_id,
  frozen.version_no AS version_no,
  named.channel_id AS channel_id,
  named.asset AS asset,
  named.channel AS channel,
  frozen.support_id AS support_id,
  scale.calibrated_lo AS lo,
  scale.calibrated_hi AS hi,
  frozen.m AS m,
  frozen.tau AS tau,
  frozen.bins AS bins,
  frozen.window_length AS window_length,
  frozen.stride AS stride,
  frozen.max_gap AS max_gap,
  frozen.still_after AS still_after,
  frozen.program_column AS program_column,
  frozen.score_from AS score_from,
  frozen.calibration_end AS calibration_end,
  frozen.first_scored AS first_scored,
  frozen.run_up_from AS run_up_from,
  frozen.calibration_readings AS calibration_readings,
  frozen.settings_hash AS settings_hash,
  frozen.created AS created
FROM stored_version AS frozen
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS latest ON latest.channel_id = frozen.channel_id AND latest.newest_id = frozen.version_id
JOIN stored_channel AS named ON named.channel_id = frozen.channel_id
JOIN stored_bounds AS scale ON scale.support_id = frozen.support_id
WHERE named.monitor_id = :monitor_id
