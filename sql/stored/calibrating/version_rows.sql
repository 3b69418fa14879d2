-- Version rows: what is frozen with a calibration. Appended last of all: they commit it.
-- Reads:  numbering, bounds, run_up, recount
-- A row:  one version of one channel; run_up_from reaches back (m-1) tau samples before the first vector to
--         be scored, and still_after - 1 more by which still ones are told, or over everything where there are
--         not that many.
-- Slots:  :long_ago  an instant before all others
--         :created
SELECT
  numbered.version_id AS version_id,
  numbered.stored_channel_id AS channel_id,
  numbered.stored_support_id AS support_id,
  numbered.parent_id AS parent_id,
  numbered.version_no AS version_no,
  'active' AS status,
  numbered.reason AS reason,
  numbered.m AS m,
  numbered.tau AS tau,
  numbered.bins AS bins,
  numbered.window_length AS window_length,
  numbered.stride AS stride,
  numbered.max_gap AS max_gap,
  numbered.still_after AS still_after,
  numbered.score_from AS score_from,
  numbered.target_floor AS target_floor,
  numbered.least_vectors AS least_vectors,
  numbered.is_robust AS is_robust,
  numbered.program_column AS program_column,
  numbered.program_weight AS program_weight,
  scale.calibration_end AS calibration_end,
  scale.first_scored AS first_scored,
  CASE
    WHEN earlier.hit = 1
      AND earlier.context_rows
        = (numbered.m - 1) * numbered.tau
          + CASE WHEN numbered.still_after IS NULL THEN 0 ELSE numbered.still_after - 1 END
      THEN earlier.read_from
    ELSE CAST(:long_ago AS BIGINT)
  END AS run_up_from,
  CASE WHEN counted.hit = 1 THEN counted.calibration_readings ELSE 0 END AS calibration_readings,
  CAST(scale.calibration_samples AS BIGINT) AS calibration_samples,
  numbered.settings_hash AS settings_hash,
  numbered.method_hash AS method_hash,
  CAST(:created AS BIGINT) AS created
FROM numbering AS numbered
JOIN bounds AS scale ON scale.channel_id = numbered.channel_id
LEFT JOIN (
  SELECT channel_id, read_from, context_rows, 1 AS hit
  FROM run_up
) AS earlier ON earlier.channel_id = numbered.channel_id
LEFT JOIN (
  SELECT channel_id, calibration_readings, 1 AS hit
  FROM recount
) AS counted ON counted.channel_id = numbered.channel_id
