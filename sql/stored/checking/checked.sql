-- Checked: the versions of a monitor, retired ones too, with what the checks of them must know.
-- Reads:  stored_version, stored_channel, stored_bounds, stored_block, stored_calibration,
--         stored_horizon, stored_finished_run
-- A row:  one version; is_active = 1 if its channel is scored by it now. started is when its newest run began, read_to is
--         that of the newest run that read anything, counted_readings what the newest run that counted calibration
--         found. Calibration begins at calibration_from, and teaches from taught_from on.
-- Slots:  :monitor_id
SELECT
  version.version_id AS version_id,
  version.channel_id AS channel_id,
  version.support_id AS support_id,
  named.asset AS asset,
  named.channel AS channel,
  version.parent_id AS parent_id,
  version.version_no AS version_no,
  version.status AS status,
  version.reason AS reason,
  version.m AS m,
  version.tau AS tau,
  version.bins AS bins,
  version.window_length AS window_length,
  version.stride AS stride,
  version.max_gap AS max_gap,
  version.still_after AS still_after,
  version.score_from AS score_from,
  version.target_floor AS target_floor,
  version.least_vectors AS least_vectors,
  version.is_robust AS is_robust,
  version.calibration_end AS calibration_end,
  version.first_scored AS first_scored,
  version.calibration_readings AS calibration_readings,
  CASE WHEN taught.hit = 1 THEN taught.taught_from END AS taught_from,
  CASE WHEN healthy.hit = 1 THEN healthy.calibration_from END AS calibration_from,
  CASE WHEN done.hit = 1 THEN done.started END AS started,
  CASE
    WHEN version.still_after IS NOT NULL THEN (version.m - 1) * version.tau + version.still_after - 1
    WHEN version.m = 1 THEN 1
    ELSE (version.m - 1) * version.tau
  END AS context_rows,
  version.run_up_from AS run_up_from,
  CASE WHEN scale.hit = 1 THEN scale.lo END AS lo,
  CASE WHEN scale.hit = 1 THEN scale.hi END AS hi,
  CASE WHEN latest.newest_id = version.version_id THEN 1 ELSE 0 END AS is_active,
  CASE WHEN pruned.hit = 1 THEN pruned.first_bucket ELSE 0 END AS first_bucket,
  CASE WHEN pruned.hit = 1 THEN pruned.first_novel ELSE 0 END AS first_novel,
  CASE WHEN done.hit = 1 THEN done.read_to END AS read_to,
  CASE WHEN done.hit = 1 THEN done.counted_readings END AS counted_readings,
  version.program_column AS program_column
FROM stored_version AS version
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS latest ON latest.channel_id = version.channel_id
LEFT JOIN (
  SELECT support_id, MIN(learnt.calibrated_lo) AS lo, MIN(learnt.calibrated_hi) AS hi, 1 AS hit
  FROM stored_bounds AS learnt
  GROUP BY support_id
) AS scale ON scale.support_id = version.support_id
LEFT JOIN (
  SELECT support_id, channel_id, MIN(part.first_time) AS taught_from, 1 AS hit
  FROM stored_block AS part
  GROUP BY support_id, channel_id
) AS taught ON taught.support_id = version.support_id AND taught.channel_id = version.channel_id
LEFT JOIN (
  SELECT version_id, MIN(piece.time_from) AS calibration_from, 1 AS hit
  FROM stored_calibration AS piece
  GROUP BY version_id
) AS healthy ON healthy.version_id = version.version_id
LEFT JOIN (
  SELECT
    version_id,
    MAX(horizon.first_bucket) AS first_bucket,
    MAX(horizon.first_novel) AS first_novel,
    1 AS hit
  FROM stored_horizon AS horizon
  GROUP BY version_id
) AS pruned ON pruned.version_id = version.version_id
LEFT JOIN (
  SELECT
    version_id,
    MAX(run.started) AS started,
    MAX(CASE WHEN run.run_id = reading_id THEN run.read_to END) AS read_to,
    MAX(CASE WHEN run.run_id = counting_id THEN run.calibration_readings END) AS counted_readings,
    1 AS hit
  FROM (
    SELECT
      version_id,
      run_id,
      started,
      read_to,
      calibration_readings,
      MAX(CASE WHEN settled_bucket IS NOT NULL THEN run_id END) OVER (PARTITION BY version_id)
        AS reading_id,
      MAX(CASE WHEN calibration_readings IS NOT NULL THEN run_id END) OVER (PARTITION BY version_id)
        AS counting_id
    FROM stored_finished_run
  ) AS run
  GROUP BY version_id
) AS done ON done.version_id = version.version_id
WHERE named.monitor_id = :monitor_id
