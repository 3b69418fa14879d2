-- Signals: what is known of each signal of one monitor now, with when its calibration began and ended.
-- Reads:  stored_fleet, stored_trend, stored_version, stored_block
-- A row:  one signal under its active version; times are integers. learnt_from is NULL without calibration.
-- Slots:  :monitor  its name
SELECT
  known.asset AS asset,
  known.channel AS channel,
  known.version_no AS version_no,
  known.version_id AS version_id,
  version.support_id AS support_id,
  version.channel_id AS channel_id,
  version.calibration_end AS calibration_end,
  CASE WHEN learnt.hit = 1 THEN learnt.begun END AS learnt_from,
  known.verdict AS verdict,
  known.status AS status,
  known.is_above AS is_above,
  known.judged_by AS judged_by,
  known.episode_id AS episode_id,
  known.label AS label,
  known.is_far_above AS is_far_above,
  known.strength AS strength,
  known.floor AS floor,
  known.floor_sd AS floor_sd,
  known.hi_limit AS hi_limit,
  known.limit_reason AS limit_reason,
  known.hi AS hi,
  known.novel_in_window AS novel_in_window,
  known.novel_window_before AS novel_window_before,
  moved.is_rising AS is_rising,
  known.out_of_range_in_window AS out_of_range_in_window,
  known.since_tick AS since_tick,
  known.at_least AS at_least,
  known.silent_for AS silent_for,
  known.data_tick AS data_tick,
  known.last_tick AS last_tick,
  known.cells AS cells,
  known.calibration_vectors AS calibration_vectors,
  known.calibrated_lo AS calibrated_lo,
  known.calibrated_hi AS calibrated_hi,
  known.finest_bins AS finest_bins,
  known.vectors_needed AS vectors_needed,
  known.sees AS sees,
  known.would_not_see AS would_not_see,
  known.blind_reason AS blind_reason,
  known.vouching AS vouching,
  known.taught_by AS taught_by,
  known.member_floor AS member_floor,
  known.target_floor AS target_floor,
  version.max_gap AS max_gap,
  version.program_weight AS program_weight,
  known.window_length AS window_length,
  known.stride AS stride,
  known.m AS m,
  known.tau AS tau,
  known.bins AS bins
FROM stored_fleet AS known
JOIN stored_trend AS moved ON moved.version_id = known.version_id
JOIN stored_version AS version ON version.version_id = known.version_id
LEFT JOIN (
  SELECT support_id, channel_id, MIN(first_time) AS begun, 1 AS hit
  FROM stored_block
  GROUP BY support_id, channel_id
) AS learnt ON learnt.support_id = version.support_id AND learnt.channel_id = version.channel_id
WHERE known.monitor = :monitor
