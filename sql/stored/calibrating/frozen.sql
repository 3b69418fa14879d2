-- Frozen: the wanted versions as they are stored, with all integers that calibration froze.
-- Reads:  stored_version, wanted
-- A row:  one version.
SELECT
  made.version_id AS version_id,
  made.support_id AS support_id,
  made.target_floor AS target_floor,
  made.settings_hash AS settings_hash,
  made.method_hash AS method_hash,
  made.channel_id AS channel_id,
  made.parent_id AS parent_id,
  made.version_no AS version_no,
  made.m AS m,
  made.tau AS tau,
  made.bins AS bins,
  made.window_length AS window_length,
  made.stride AS stride,
  made.max_gap AS max_gap,
  made.still_after AS still_after,
  made.program_column AS program_column,
  made.program_weight AS program_weight,
  made.least_vectors AS least_vectors,
  made.is_robust AS is_robust,
  made.score_from AS score_from,
  made.calibration_end AS calibration_end,
  made.first_scored AS first_scored,
  made.run_up_from AS run_up_from,
  made.calibration_readings AS calibration_readings,
  made.calibration_samples AS calibration_samples,
  made.created AS created
FROM stored_version AS made
JOIN (
  SELECT version_id
  FROM wanted
  GROUP BY version_id
) AS asked ON asked.version_id = made.version_id
