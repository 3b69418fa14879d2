-- Signals: what is known of each signal of one monitor now, with when its calibration began and ended.
-- Reads:  stored_fleet, stored_trend, stored_version, stored_block
-- A row:  one signal under its active version; times are integers. learnt_from is NULL without calibration.
-- Slots:  :monitor  its name
SELECT
  fleet_row.asset AS asset,
  fleet_row.channel AS channel,
  fleet_row.version_no AS version_no,
  fleet_row.version_id AS version_id,
  version.support_id AS support_id,
  version.channel_id AS channel_id,
  version.calibration_end AS calibration_end,
  CASE WHEN learnt.hit = 1 THEN learnt.begun END AS learnt_from,
  fleet_row.verdict AS verdict,
  fleet_row.status AS status,
  fleet_row.is_above AS is_above,
  fleet_row.judged_by AS judged_by,
  fleet_row.episode_id AS episode_id,
  fleet_row.label AS label,
  fleet_row.is_far_above AS is_far_above,
  fleet_row.strength AS strength,
  fleet_row.floor AS floor,
  fleet_row.floor_sd AS floor_sd,
  fleet_row.hi_limit AS hi_limit,
  fleet_row.limit_reason AS limit_reason,
  fleet_row.hi AS hi,
  fleet_row.novel_in_window AS novel_in_window,
  fleet_row.novel_window_before AS novel_window_before,
  moved.is_rising AS is_rising,
  fleet_row.out_of_range_in_window AS out_of_range_in_window,
  fleet_row.since_tick AS since_tick,
  fleet_row.at_least AS at_least,
  fleet_row.silent_for AS silent_for,
  fleet_row.data_tick AS data_tick,
  fleet_row.last_tick AS last_tick,
  fleet_row.cells AS cells,
  fleet_row.calibration_vectors AS calibration_vectors,
  fleet_row.calibrated_lo AS calibrated_lo,
  fleet_row.calibrated_hi AS calibrated_hi,
  fleet_row.finest_bins AS finest_bins,
  fleet_row.vectors_needed AS vectors_needed,
  fleet_row.sees AS sees,
  fleet_row.would_not_see AS would_not_see,
  fleet_row.blind_reason AS blind_reason,
  fleet_row.vouching AS vouching,
  fleet_row.taught_by AS taught_by,
  fleet_row.member_floor AS member_floor,
  fleet_row.target_floor AS target_floor,
  version.max_gap AS max_gap,
  version.program_weight AS program_weight,
  fleet_row.window_length AS window_length,
  fleet_row.stride AS stride,
  fleet_row.m AS m,
  fleet_row.tau AS tau,
  fleet_row.bins AS bins
FROM stored_fleet AS fleet_row
JOIN stored_trend AS moved ON moved.version_id = fleet_row.version_id
JOIN stored_version AS version ON version.version_id = fleet_row.version_id
LEFT JOIN (
  SELECT support_id, channel_id, MIN(first_time) AS begun, 1 AS hit
  FROM stored_block
  GROUP BY support_id, channel_id
) AS learnt ON learnt.support_id = version.support_id AND learnt.channel_id = version.channel_id
WHERE fleet_row.monitor = :monitor
