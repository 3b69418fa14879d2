-- Status rows: what the state says of the channels of one monitor, for gam status.
-- Reads:  stored_fleet
-- A row:  one channel under its active version; times are integers.
-- Slots:  :monitor  its name
SELECT
  asset,
  channel,
  version_no,
  version_id,
  verdict,
  status,
  urgency,
  needs_attention,
  floor,
  hi_limit,
  limit_reason,
  calibrated_lo,
  calibration_vectors,
  finest_bins,
  vectors_needed,
  hi,
  hi_highest,
  novel_in_window,
  novel_window_before,
  out_of_range_in_window,
  novel_in_buckets,
  window_length,
  stride,
  m,
  tau,
  bins,
  bucket,
  last_tick,
  data_tick,
  looked_at,
  differing_contexts,
  repair_from_tick,
  calibration_readings,
  calibration_readings_now,
  settings_hash,
  method_hash
FROM stored_fleet
WHERE monitor = :monitor
