-- Check summary: what a channel looks like before anything is learnt of it.
-- Reads:  names, channels, series, movements, longest_stills, pauses, quanta, cycles, calibrated,
--         stood
-- A row:  one (asset, channel) pair, in order; where a name is missing, or no row has a time, only the
--         rows are counted.
-- Slots:  :first_time, :last_time  the instants of the first and last sample as the source tells time
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(named.readings + named.without_time AS BIGINT) AS readings,
  CAST(named.without_time AS BIGINT) AS without_time,
  CASE WHEN figures.hit = 1 THEN figures.settings_no END AS settings_no,
  CASE WHEN figures.hit = 1 THEN figures.samples END AS samples,
  CASE WHEN figures.hit = 1 THEN named.readings - figures.samples END AS repeated,
  CASE WHEN figures.hit = 1 THEN CAST(figures.conflicts AS BIGINT) END AS conflicts,
  CASE WHEN figures.hit = 1 THEN figures.missing END AS missing,
  CASE WHEN figures.hit = 1 THEN figures.first_time END AS first_tick,
  CASE WHEN figures.hit = 1 THEN figures.last_time END AS last_tick,
  CASE WHEN figures.hit = 1 THEN :first_time END AS first_time,
  CASE WHEN figures.hit = 1 THEN :last_time END AS last_time,
  CASE WHEN spaced.hit = 1 THEN spaced.typical_step END AS typical_step,
  CASE WHEN spaced.hit = 1 THEN spaced.short_step END AS short_step,
  CASE WHEN spaced.hit = 1 THEN spaced.long_step END AS long_step,
  CASE WHEN spaced.hit = 1 THEN spaced.typical_steps END AS typical_steps,
  CASE WHEN spaced.hit = 1 THEN spaced.pauses ELSE 0 END AS pauses,
  CASE WHEN spaced.hit = 1 THEN spaced.longest_step END AS longest_step,
  CASE WHEN spaced.hit = 1 THEN spaced.shortest_pause END AS shortest_pause,
  CASE WHEN spaced.hit = 1 THEN spaced.longest_pause END AS longest_pause,
  CASE WHEN figures.hit = 1 THEN figures.lowest END AS lowest,
  CASE WHEN figures.hit = 1 THEN figures.highest END AS highest,
  CASE WHEN figures.hit = 1 THEN figures.rises END AS rises,
  CASE WHEN figures.hit = 1 THEN figures.falls END AS falls,
  CASE WHEN figures.hit = 1 THEN figures.stills END AS stills,
  CASE
    WHEN lasting.hit = 1 THEN lasting.longest_still
    WHEN figures.hit = 1 AND figures.missing < figures.samples THEN 1
    ELSE 0
  END AS longest_still,
  CASE WHEN levelled.hit = 1 THEN levelled.values_seen ELSE 0 END AS values_seen,
  CASE WHEN levelled.hit = 1 THEN levelled.quantum END AS quantum,
  CASE WHEN cyclic.hit = 1 THEN cyclic.cycle_length END AS cycle_length,
  CASE WHEN cyclic.hit = 1 THEN cyclic.cycle_strength END AS cycle_strength,
  CASE WHEN healthy.hit = 1 THEN healthy.calibration_samples ELSE 0 END AS calibration_samples,
  CASE WHEN healthy.hit = 1 THEN healthy.lowest END AS calibration_lowest,
  CASE WHEN healthy.hit = 1 THEN healthy.highest END AS calibration_highest,
  CASE WHEN stood.hit = 1 THEN stood.still_after END AS still_after,
  CASE WHEN stood.hit = 1 THEN stood.calibration_still ELSE 0 END AS calibration_still,
  CASE WHEN stood.hit = 1 THEN stood.still_runs ELSE 0 END AS still_runs,
  CASE WHEN stood.hit = 1 THEN stood.longest_run END AS longest_run
FROM names AS named
LEFT JOIN (
  SELECT
    listed.asset AS asset,
    listed.channel AS channel,
    listed.channel_id AS channel_id,
    listed.settings_no AS settings_no,
    extent.samples AS samples,
    extent.conflicts AS conflicts,
    extent.first_time AS first_time,
    movement.last_time AS last_time,
    movement.missing AS missing,
    movement.rises AS rises,
    movement.falls AS falls,
    movement.stills AS stills,
    movement.lowest AS lowest,
    movement.highest AS highest,
    1 AS hit
  FROM channels AS listed
  JOIN series AS extent ON extent.channel_id = listed.channel_id
  JOIN movements AS movement ON movement.channel_id = listed.channel_id
) AS figures ON figures.asset = named.asset AND figures.channel = named.channel
LEFT JOIN (
  SELECT
    channel_id,
    typical_step,
    short_step,
    long_step,
    typical_steps,
    pauses,
    longest_step,
    shortest_pause,
    longest_pause,
    1 AS hit
  FROM pauses
) AS spaced ON spaced.channel_id = figures.channel_id
LEFT JOIN (
  SELECT channel_id, longest_still, 1 AS hit FROM longest_stills
) AS lasting ON lasting.channel_id = figures.channel_id
LEFT JOIN (
  SELECT channel_id, values_seen, quantum, 1 AS hit FROM quanta
) AS levelled ON levelled.channel_id = figures.channel_id
LEFT JOIN (
  SELECT channel_id, cycle_length, cycle_strength, 1 AS hit FROM cycles
) AS cyclic ON cyclic.channel_id = figures.channel_id
LEFT JOIN (
  SELECT channel_id, calibration_samples, lowest, highest, 1 AS hit FROM calibrated
) AS healthy ON healthy.channel_id = figures.channel_id
LEFT JOIN (
  SELECT channel_id, still_after, calibration_still, still_runs, longest_run, 1 AS hit FROM stood
) AS stood ON stood.channel_id = figures.channel_id
ORDER BY named.asset, named.channel
