-- Frozen: the wanted versions as they are stored, with all integers that calibration froze.
-- Reads:  stored_version, wanted
-- A row:  one version.
SELECT
  version.version_id AS version_id,
  version.support_id AS support_id,
  version.target_floor AS target_floor,
  version.settings_hash AS settings_hash,
  version.method_hash AS method_hash,
  version.channel_id AS channel_id,
  version.parent_id AS parent_id,
  version.version_no AS version_no,
  version.m AS m,
  version.tau AS tau,
  version.bins AS bins,
  version.window_length AS window_length,
  version.stride AS stride,
  version.max_gap AS max_gap,
  version.still_after AS still_after,
  version.program_column AS program_column,
  version.program_weight AS program_weight,
  version.least_vectors AS least_vectors,
  version.is_robust AS is_robust,
  version.score_from AS score_from,
  version.calibration_end AS calibration_end,
  version.first_scored AS first_scored,
  version.run_up_from AS run_up_from,
  version.calibration_readings AS calibration_readings,
  version.calibration_samples AS calibration_samples,
  version.created AS created
FROM stored_version AS version
JOIN (
  SELECT version_id
  FROM wanted
  GROUP BY version_id
) AS wanted_version ON wanted_version.version_id = version.version_id
