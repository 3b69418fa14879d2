-- Status rows: what the state says of the channels of one monitor, for gam status.
-- Reads:  stored_fleet, stored_stillness, stored_version, stored_bounds, stored_run, stored_finished_run
-- A row:  one channel under its active version; times are integers. gone_from is where the context of its newest run
--         would have begun, had it not gone from the source.
-- Slots:  :monitor   its name
--         :long_ago  an instant before all others
SELECT
  fleet_row.asset AS asset,
  fleet_row.channel AS channel,
  fleet_row.version_no AS version,
  fleet_row.version_id AS version_id,
  fleet_row.verdict AS verdict,
  fleet_row.status AS status,
  fleet_row.urgency AS urgency,
  fleet_row.needs_attention AS needs_attention,
  fleet_row.floor AS floor,
  fleet_row.hi_limit AS hi_limit,
  fleet_row.limit_reason AS limit_reason,
  fleet_row.calibrated_lo AS calibrated_lo,
  fleet_row.calibrated_hi AS calibrated_hi,
  scale.dropped_below AS dropped_below,
  scale.dropped_above AS dropped_above,
  scale.lowest_dropped AS lowest_dropped,
  scale.highest_dropped AS highest_dropped,
  fleet_row.calibration_vectors AS calibration_vectors,
  fleet_row.finest_bins AS finest_bins,
  fleet_row.vectors_needed AS vectors_needed,
  scale.usual_low AS usual_low,
  scale.usual_high AS usual_high,
  fleet_row.sees AS sees,
  fleet_row.sees_half_stroke AS sees_half_stroke,
  fleet_row.sees_frozen AS sees_frozen,
  fleet_row.sees_faster AS sees_faster,
  fleet_row.sees_slower AS sees_slower,
  fleet_row.would_not_see AS would_not_see,
  fleet_row.blind_reason AS blind_reason,
  fleet_row.vouched_by AS vouched_by,
  fleet_row.taught_by AS taught_by,
  fleet_row.member_floor AS member_floor,
  fleet_row.hi AS hi,
  fleet_row.hi_highest AS hi_highest,
  fleet_row.novel_in_window AS novel_in_window,
  fleet_row.novel_window_before AS novel_window_before,
  CAST(fleet_row.novel_in_window - fleet_row.novel_window_before AS DOUBLE) / CAST(fleet_row.window_length AS DOUBLE)
    AS trend,
  fleet_row.out_of_range_in_window AS out_of_range_in_window,
  fleet_row.novel_in_buckets AS novel_in_buckets,
  fleet_row.window_length AS window_length,
  fleet_row.stride AS stride,
  fleet_row.m AS m,
  fleet_row.tau AS tau,
  fleet_row.bins AS bins,
  fleet_row.bucket AS bucket,
  fleet_row.last_tick AS last_time,
  fleet_row.data_tick AS last_data,
  fleet_row.looked_at AS looked_at,
  fleet_row.differing_contexts AS differing_contexts,
  fleet_row.repair_from_tick AS repair_from,
  fleet_row.calibration_readings AS calibration_rows,
  fleet_row.calibration_readings_now - fleet_row.calibration_readings AS calibration_rows_added,
  fleet_row.settings_hash AS settings_hash,
  fleet_row.method_hash AS method_hash,
  fleet_row.is_above AS is_above,
  fleet_row.judged_by AS judged_by,
  fleet_row.episode_id AS episode,
  fleet_row.asking AS asking,
  fleet_row.label AS label,
  fleet_row.is_far_above AS is_far_above,
  fleet_row.strength AS strength,
  fleet_row.since_tick AS onset,
  CASE WHEN still.hit = 1 THEN still.still_since_tick END AS still_since,
  version_row.calibration_end AS calibration_end,
  CASE WHEN lost.hit = 1 THEN lost.gone_from END AS gone_from
FROM stored_fleet AS fleet_row
JOIN stored_version AS version_row ON version_row.version_id = fleet_row.version_id
JOIN stored_bounds AS scale ON scale.support_id = version_row.support_id
LEFT JOIN (
  SELECT version_id, still_since_tick, 1 AS hit
  FROM stored_stillness
) AS still ON still.version_id = fleet_row.version_id
LEFT JOIN (
  SELECT version_id, MAX(run.read_from) AS gone_from, 1 AS hit
  FROM (
    SELECT done.version_id AS version_id, done.read_from AS read_from
    FROM stored_finished_run AS done
    JOIN stored_run AS making ON making.version_id = done.version_id AND making.run_id = done.run_id
    JOIN (
      SELECT version_id, MAX(run_id) AS newest_id
      FROM stored_finished_run
      WHERE read_to IS NOT NULL
      GROUP BY version_id
    ) AS reading ON reading.version_id = done.version_id AND reading.newest_id = done.run_id
    WHERE making.made_from > 0 AND done.context_expected IS NULL AND done.read_from > CAST(:long_ago AS BIGINT)
  ) AS run
  GROUP BY version_id
) AS lost ON lost.version_id = fleet_row.version_id
WHERE fleet_row.monitor = :monitor
