-- Status rows: what the state says of the channels of one monitor, for gam status.
-- Reads:  stored_fleet, stored_stillness, stored_version, stored_bounds, stored_run, stored_finished_run
-- A row:  one channel under its active version; times are integers. gone_from is where the context of its newest run
--         would have begun, had it not gone from the source.
-- Slots:  :monitor   its name
--         :long_ago  an instant before all others
SELECT
  known.asset AS asset,
  known.channel AS channel,
  known.version_no AS version,
  known.version_id AS version_id,
  known.verdict AS verdict,
  known.status AS status,
  known.urgency AS urgency,
  known.needs_attention AS needs_attention,
  known.floor AS floor,
  known.hi_limit AS hi_limit,
  known.limit_reason AS limit_reason,
  known.calibrated_lo AS calibrated_lo,
  known.calibrated_hi AS calibrated_hi,
  scale.dropped_below AS dropped_below,
  scale.dropped_above AS dropped_above,
  scale.lowest_dropped AS lowest_dropped,
  scale.highest_dropped AS highest_dropped,
  known.calibration_vectors AS calibration_vectors,
  known.finest_bins AS finest_bins,
  known.vectors_needed AS vectors_needed,
  scale.usual_low AS usual_low,
  scale.usual_high AS usual_high,
  known.sees AS sees,
  known.sees_half_stroke AS sees_half_stroke,
  known.sees_frozen AS sees_frozen,
  known.sees_faster AS sees_faster,
  known.sees_slower AS sees_slower,
  known.would_not_see AS would_not_see,
  known.blind_reason AS blind_reason,
  known.vouched_by AS vouched_by,
  known.taught_by AS taught_by,
  known.member_floor AS member_floor,
  known.hi AS hi,
  known.hi_highest AS hi_highest,
  known.novel_in_window AS novel_in_window,
  known.novel_window_before AS novel_window_before,
  CAST(known.novel_in_window - known.novel_window_before AS DOUBLE) / CAST(known.window_length AS DOUBLE)
    AS trend,
  known.out_of_range_in_window AS out_of_range_in_window,
  known.novel_in_buckets AS novel_in_buckets,
  known.window_length AS window_length,
  known.stride AS stride,
  known.m AS m,
  known.tau AS tau,
  known.bins AS bins,
  known.bucket AS bucket,
  known.last_tick AS last_time,
  known.data_tick AS last_data,
  known.looked_at AS looked_at,
  known.differing_contexts AS differing_contexts,
  known.repair_from_tick AS repair_from,
  known.calibration_readings AS calibration_rows,
  known.calibration_readings_now - known.calibration_readings AS calibration_rows_added,
  known.settings_hash AS settings_hash,
  known.method_hash AS method_hash,
  known.is_above AS is_above,
  known.judged_by AS judged_by,
  known.episode_id AS episode,
  known.asking AS asking,
  known.label AS label,
  known.is_far_above AS is_far_above,
  known.strength AS strength,
  known.since_tick AS onset,
  CASE WHEN still.hit = 1 THEN still.still_since_tick END AS still_since,
  made.calibration_end AS calibration_end,
  CASE WHEN lost.hit = 1 THEN lost.gone_from END AS gone_from
FROM stored_fleet AS known
JOIN stored_version AS made ON made.version_id = known.version_id
JOIN stored_bounds AS scale ON scale.support_id = made.support_id
LEFT JOIN (
  SELECT version_id, still_since_tick, 1 AS hit
  FROM stored_stillness
) AS still ON still.version_id = known.version_id
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
) AS lost ON lost.version_id = known.version_id
WHERE known.monitor = :monitor
