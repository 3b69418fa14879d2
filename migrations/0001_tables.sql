-- Migration: which of these files were applied to this database.
CREATE TABLE IF NOT EXISTS stored_migration (
  number BIGINT NOT NULL,
  name VARCHAR NOT NULL,
  checksum VARCHAR NOT NULL,
  applied_at BIGINT NOT NULL,
  gam_version VARCHAR NOT NULL
);

COMMENT ON TABLE stored_migration IS 'Migrations applied to these tables, in order; gam migrate writes it';
COMMENT ON COLUMN stored_migration.number IS 'Number of the migration';
COMMENT ON COLUMN stored_migration.name IS 'What it makes or changes';
COMMENT ON COLUMN stored_migration.checksum IS 'SHA-256 of its file; a released migration never changes';
COMMENT ON COLUMN stored_migration.applied_at IS 'When it was applied, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_migration.gam_version IS 'The gam-db that applied it';

-- Monitor: one source watched under one name; a database may hold several.
CREATE TABLE IF NOT EXISTS stored_monitor (
  monitor_id BIGINT NOT NULL,
  name VARCHAR NOT NULL,
  source VARCHAR NOT NULL,
  layout VARCHAR NOT NULL,
  asset_column VARCHAR,
  channel_column VARCHAR,
  time_column VARCHAR NOT NULL,
  value_column VARCHAR,
  condition VARCHAR,
  time_kind VARCHAR NOT NULL,
  created BIGINT NOT NULL
);

COMMENT ON TABLE stored_monitor IS 'One source watched under one name; one row per monitor';
COMMENT ON COLUMN stored_monitor.monitor_id IS 'Key of the monitor';
COMMENT ON COLUMN stored_monitor.name IS 'Its name, unique in these tables';
COMMENT ON COLUMN stored_monitor.source IS 'The relation it reads';
COMMENT ON COLUMN stored_monitor.layout IS 'long (a row per reading) or wide (a column per channel)';
COMMENT ON COLUMN stored_monitor.asset_column IS 'Column that names the machine; NULL if there is only one';
COMMENT ON COLUMN stored_monitor.channel_column
  IS 'Column that names the signal; NULL if there is only one, or a column for each';
COMMENT ON COLUMN stored_monitor.time_column IS 'Column with the time of a reading';
COMMENT ON COLUMN stored_monitor.value_column IS 'Column with the reading; NULL if there is one per channel';
COMMENT ON COLUMN stored_monitor.condition IS 'Which rows are taken, in SQL; NULL for all';
COMMENT ON COLUMN stored_monitor.time_kind IS 'How the source tells time: counter, or a kind of timestamp';
COMMENT ON COLUMN stored_monitor.created IS 'When it was made, in microseconds since 1970 (UTC)';

-- Channel: one signal of one machine.
CREATE TABLE IF NOT EXISTS stored_channel (
  channel_id BIGINT NOT NULL,
  monitor_id BIGINT NOT NULL,
  asset VARCHAR NOT NULL,
  channel VARCHAR NOT NULL
);

COMMENT ON TABLE stored_channel IS 'One signal of one machine, as a monitor found it; one row per channel';
COMMENT ON COLUMN stored_channel.channel_id IS 'Key of the channel';
COMMENT ON COLUMN stored_channel.monitor_id IS 'The monitor that watches it';
COMMENT ON COLUMN stored_channel.asset IS 'The machine';
COMMENT ON COLUMN stored_channel.channel IS 'The signal';

-- Version: one calibration of one channel, with all that scoring against it needs. Written last of
-- all that a calibration writes; the version with the largest key is the active one.
CREATE TABLE IF NOT EXISTS stored_version (
  version_id BIGINT NOT NULL,
  channel_id BIGINT NOT NULL,
  support_id BIGINT NOT NULL,
  parent_id BIGINT,
  version_no BIGINT NOT NULL,
  status VARCHAR NOT NULL,
  reason VARCHAR NOT NULL,
  m BIGINT NOT NULL,
  tau BIGINT NOT NULL,
  bins BIGINT NOT NULL,
  window_length BIGINT NOT NULL,
  stride BIGINT NOT NULL,
  max_gap BIGINT,
  score_from BIGINT,
  target_floor DOUBLE NOT NULL,
  calibration_end BIGINT,
  first_scored BIGINT NOT NULL,
  run_up_from BIGINT NOT NULL,
  calibration_readings BIGINT NOT NULL,
  calibration_samples BIGINT NOT NULL,
  settings_hash VARCHAR NOT NULL,
  method_hash VARCHAR NOT NULL,
  created BIGINT NOT NULL,
  still_after BIGINT,
  least_vectors BIGINT,
  is_robust BIGINT NOT NULL,
  program_column VARCHAR,
  program_weight BIGINT
);

COMMENT ON TABLE stored_version
  IS 'Calibrations of channels; of each channel the one with the largest version_id is active';
COMMENT ON COLUMN stored_version.version_id IS 'Key of the version; a later one is larger';
COMMENT ON COLUMN stored_version.channel_id IS 'The channel';
COMMENT ON COLUMN stored_version.support_id IS 'What was learnt; versions of a pool share it';
COMMENT ON COLUMN stored_version.parent_id IS 'The version it replaced; NULL for the first';
COMMENT ON COLUMN stored_version.version_no IS '1, 2, ... within the channel';
COMMENT ON COLUMN stored_version.status IS 'active when it was made';
COMMENT ON COLUMN stored_version.reason IS 'Why it was made';
COMMENT ON COLUMN stored_version.m IS 'Embedding dimension';
COMMENT ON COLUMN stored_version.tau IS 'Delay, in samples';
COMMENT ON COLUMN stored_version.bins IS 'Bins per axis';
COMMENT ON COLUMN stored_version.window_length IS 'Scored vectors in the moving average';
COMMENT ON COLUMN stored_version.stride IS 'Scored vectors in a bucket; divides window_length';
COMMENT ON COLUMN stored_version.max_gap IS 'Longest step in time that is no pause; NULL for no limit';
COMMENT ON COLUMN stored_version.score_from IS 'First instant to score, where it was set; NULL for after calibration';
COMMENT ON COLUMN stored_version.target_floor IS 'Health indicator that a healthy machine may show';
COMMENT ON COLUMN stored_version.calibration_end IS 'Last instant of calibration; NULL without calibration';
COMMENT ON COLUMN stored_version.first_scored IS 'First instant that is scored; -2^62 is from the first sample on';
COMMENT ON COLUMN stored_version.run_up_from IS 'From where on a first run reads; -2^62 is everything';
COMMENT ON COLUMN stored_version.calibration_readings IS 'Rows of the source inside calibration when it was made';
COMMENT ON COLUMN stored_version.calibration_samples IS 'Samples inside calibration when it was made';
COMMENT ON COLUMN stored_version.settings_hash IS 'Hash of the settings it was made under';
COMMENT ON COLUMN stored_version.method_hash IS 'Hash of the SQL that learnt it';
COMMENT ON COLUMN stored_version.created IS 'When it was made, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_version.still_after
  IS 'Equal samples in a row from which on the signal stands still and counts as missing; NULL for never';
COMMENT ON COLUMN stored_version.least_vectors
  IS 'Calibration vectors below which the verdict is needs_data; NULL for any number';
COMMENT ON COLUMN stored_version.is_robust
  IS '1 if a few values far from the rest may be left out of the calibrated range, else 0';
COMMENT ON COLUMN stored_version.program_column
  IS 'Column of the source that says which program the machine runs; NULL where states are of no program';
COMMENT ON COLUMN stored_version.program_weight
  IS 'By how much the keys of two programs differ: (bins + 3)^m; NULL where states are of no program';

-- Calibration: the intervals a version learnt from, as they were resolved then.
CREATE TABLE IF NOT EXISTS stored_calibration (
  version_id BIGINT NOT NULL,
  time_from BIGINT NOT NULL,
  time_to BIGINT NOT NULL
);

COMMENT ON TABLE stored_calibration
  IS 'Closed intervals of time that a version learnt from, frozen; one row per interval';
COMMENT ON COLUMN stored_calibration.version_id IS 'The version';
COMMENT ON COLUMN stored_calibration.time_from IS 'First instant of the interval';
COMMENT ON COLUMN stored_calibration.time_to IS 'Last instant of the interval, itself included';

-- Bounds: the range of a support, and the certificate of its calibration.
CREATE TABLE IF NOT EXISTS stored_bounds (
  support_id BIGINT NOT NULL,
  calibrated_lo DOUBLE,
  calibrated_hi DOUBLE,
  dropped_below BIGINT NOT NULL,
  dropped_above BIGINT NOT NULL,
  lowest_dropped DOUBLE,
  highest_dropped DOUBLE,
  usual_low DOUBLE,
  usual_middle DOUBLE,
  usual_high DOUBLE,
  calibration_vectors BIGINT NOT NULL,
  cells BIGINT NOT NULL,
  seen_once BIGINT NOT NULL,
  blocks BIGINT NOT NULL,
  verdict VARCHAR NOT NULL,
  floor DOUBLE,
  floor_sd DOUBLE,
  floor_max DOUBLE,
  finest_bins BIGINT,
  vectors_needed BIGINT,
  sees BIGINT,
  sees_half_stroke BIGINT,
  sees_frozen BIGINT,
  sees_faster BIGINT,
  sees_slower BIGINT,
  would_not_see VARCHAR,
  blind_reason VARCHAR,
  teachers BIGINT,
  taught_by VARCHAR,
  member_verdict VARCHAR,
  member_floor DOUBLE,
  member_floor_sd DOUBLE,
  member_floor_max DOUBLE,
  member_finest_bins BIGINT
);

COMMENT ON TABLE stored_bounds IS 'Range and certificate of a support; one row per support';
COMMENT ON COLUMN stored_bounds.support_id IS 'Key of the support';
COMMENT ON COLUMN stored_bounds.calibrated_lo
  IS 'Smallest calibration value inside the range; NULL without calibration';
COMMENT ON COLUMN stored_bounds.calibrated_hi
  IS 'Largest calibration value inside the range; NULL without calibration';
COMMENT ON COLUMN stored_bounds.dropped_below
  IS 'Calibration samples below the range, left out of it as too far from the rest';
COMMENT ON COLUMN stored_bounds.dropped_above
  IS 'Calibration samples above the range, left out of it as too far from the rest';
COMMENT ON COLUMN stored_bounds.lowest_dropped IS 'The smallest of those below; NULL if there are none';
COMMENT ON COLUMN stored_bounds.highest_dropped IS 'The largest of those above; NULL if there are none';
COMMENT ON COLUMN stored_bounds.usual_low
  IS 'One in twenty calibration values lies below; NULL without calibration vectors';
COMMENT ON COLUMN stored_bounds.usual_middle IS 'The middle one of the calibration values; NULL likewise';
COMMENT ON COLUMN stored_bounds.usual_high IS 'One in twenty calibration values lies above; NULL likewise';
COMMENT ON COLUMN stored_bounds.calibration_vectors IS 'Vectors that were learnt';
COMMENT ON COLUMN stored_bounds.cells IS 'Cells that healthy operation visited';
COMMENT ON COLUMN stored_bounds.seen_once IS 'Cells visited by one vector only';
COMMENT ON COLUMN stored_bounds.blocks IS 'Blocks of one window each that calibration was cut into';
COMMENT ON COLUMN stored_bounds.verdict
  IS 'ready, blind, too_fine, needs_data, constant or no_data';
COMMENT ON COLUMN stored_bounds.floor
  IS 'Expected health indicator of healthy operation; NULL if there are too few blocks';
COMMENT ON COLUMN stored_bounds.floor_sd
  IS 'Standard deviation of the blocks around the floor; NULL if there are too few blocks';
COMMENT ON COLUMN stored_bounds.floor_max IS 'Highest block of calibration; NULL if there are too few blocks';
COMMENT ON COLUMN stored_bounds.finest_bins IS 'Finest bins that meet the target; NULL if none do';
COMMENT ON COLUMN stored_bounds.vectors_needed
  IS 'Estimate of the further calibration vectors needed; 0 if none, NULL if unknown';
COMMENT ON COLUMN stored_bounds.sees
  IS 'Smallest shift that its indicator would show both ways, in percent of the usual width, if the machine works as in calibration; NULL if none of 1 to 50 %';
COMMENT ON COLUMN stored_bounds.sees_half_stroke
  IS '1 if its indicator would show a stroke half as long, 0 if not; NULL if that could not be tried';
COMMENT ON COLUMN stored_bounds.sees_frozen IS 'The same of a sensor that gives one value only';
COMMENT ON COLUMN stored_bounds.sees_faster IS 'The same of a machine 1.5 times as fast';
COMMENT ON COLUMN stored_bounds.sees_slower IS 'The same of a machine at two thirds of its speed';
COMMENT ON COLUMN stored_bounds.would_not_see
  IS 'What of a frozen sensor, half a stroke and another speed its indicator would not show, in words; NULL if nothing is known not to';
COMMENT ON COLUMN stored_bounds.blind_reason
  IS 'Why no shift would be seen: range, blocks, cells or delay (docs/sight.md); NULL where the verdict is not blind';
COMMENT ON COLUMN stored_bounds.teachers
  IS 'Machines of its pool that taught, where others taught nothing; NULL else';
COMMENT ON COLUMN stored_bounds.taught_by
  IS 'The machines of its pool that taught, in words; NULL where a channel stands alone, or nobody taught';
COMMENT ON COLUMN stored_bounds.member_verdict
  IS 'Verdict of members that taught nothing, by leaving out one machine after another, or not_vouched; NULL where there are none';
COMMENT ON COLUMN stored_bounds.member_floor
  IS 'Health indicator to expect of a whole machine, by leaving out one after another; NULL where less than two machines taught';
COMMENT ON COLUMN stored_bounds.member_floor_sd
  IS 'Standard deviation of the machines around it; NULL where all members taught, or less than two did';
COMMENT ON COLUMN stored_bounds.member_floor_max IS 'Highest of the machines; NULL likewise';
COMMENT ON COLUMN stored_bounds.member_finest_bins
  IS 'Finest bins that meet the target for them; NULL likewise, and if none do';

-- Block: the two integers of the certificate for each block of calibration.
CREATE TABLE IF NOT EXISTS stored_block (
  support_id BIGINT NOT NULL,
  block BIGINT NOT NULL,
  channel_id BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL,
  vectors BIGINT NOT NULL,
  novel BIGINT NOT NULL
);

COMMENT ON TABLE stored_block
  IS 'Blocks of calibration, each left out and scored against the others; one row per block';
COMMENT ON COLUMN stored_block.support_id IS 'The support';
COMMENT ON COLUMN stored_block.block IS 'Number of the block within its channel, from 0';
COMMENT ON COLUMN stored_block.channel_id IS 'The channel whose vectors it holds';
COMMENT ON COLUMN stored_block.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_block.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_block.vectors IS 'Vectors in it';
COMMENT ON COLUMN stored_block.novel IS 'Those whose cell no other block visited';

-- Probe: what the indicator would show if a machine changed, as far as calibration tells.
CREATE TABLE IF NOT EXISTS stored_probe (
  support_id BIGINT NOT NULL,
  change_no BIGINT NOT NULL,
  change_name VARCHAR NOT NULL,
  vectors BIGINT,
  novel BIGINT
);

COMMENT ON TABLE stored_probe
  IS 'What the indicator would show if a machine changed; 19 changes of each support';
COMMENT ON COLUMN stored_probe.support_id IS 'The support';
COMMENT ON COLUMN stored_probe.change_no IS 'Which change it is, from 1';
COMMENT ON COLUMN stored_probe.change_name
  IS 'shift: by a part of the usual width; stroke: so many times as far from the middle; frozen; speed: so many times as fast';
COMMENT ON COLUMN stored_probe.vectors
  IS 'Vectors of calibration that were changed so; NULL where two delays would be one';
COMMENT ON COLUMN stored_probe.novel IS 'Those of them that would be novel; NULL where there are no vectors';

-- Program: what calibration knows of each program that a machine ran, where a column of the source says which.
CREATE TABLE IF NOT EXISTS stored_program (
  support_id BIGINT NOT NULL,
  program_no BIGINT NOT NULL,
  program VARCHAR NOT NULL,
  vectors BIGINT NOT NULL,
  unvouched BIGINT NOT NULL,
  verdict VARCHAR NOT NULL
);

COMMENT ON TABLE stored_program IS 'Programs that calibration holds; one row per support and program';
COMMENT ON COLUMN stored_program.support_id IS 'The support';
COMMENT ON COLUMN stored_program.program_no IS 'Its number in the keys of cells, as their highest digit: cell_key div program_weight';
COMMENT ON COLUMN stored_program.program IS 'What the machine ran';
COMMENT ON COLUMN stored_program.vectors IS 'Vectors of calibration';
COMMENT ON COLUMN stored_program.unvouched IS 'Those of them in cells that only one block of calibration visited';
COMMENT ON COLUMN stored_program.verdict IS 'ready: its vectors are judged; needs_data: calibration holds too little of it';

-- Support: the cells that healthy operation visited.
CREATE TABLE IF NOT EXISTS stored_support (
  support_id BIGINT NOT NULL,
  cell_key BIGINT NOT NULL,
  visits BIGINT NOT NULL,
  first_block BIGINT NOT NULL,
  last_block BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL
);

COMMENT ON TABLE stored_support IS 'Cells that calibration visited; one row per cell of a support';
COMMENT ON COLUMN stored_support.support_id IS 'The support';
COMMENT ON COLUMN stored_support.cell_key IS 'The cell: its bins on the m axes, as one integer';
COMMENT ON COLUMN stored_support.visits IS 'Calibration vectors in it';
COMMENT ON COLUMN stored_support.first_block IS 'First block that visited it, numbered within the support';
COMMENT ON COLUMN stored_support.last_block IS 'Last block that visited it, numbered within the support';
COMMENT ON COLUMN stored_support.first_time IS 'Time of its first visit';
COMMENT ON COLUMN stored_support.last_time IS 'Time of its last visit';

-- Bucket: scored vectors of a version, stride by stride; only full buckets are kept. Rows are visible
-- once their run is recorded; read them through visible_bucket.
CREATE TABLE IF NOT EXISTS stored_bucket (
  version_id BIGINT NOT NULL,
  bucket_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL,
  context_time BIGINT NOT NULL,
  samples BIGINT NOT NULL,
  novel BIGINT NOT NULL,
  out_of_range BIGINT NOT NULL,
  novel_in_window BIGINT,
  still BIGINT,
  unknown_program BIGINT
);

COMMENT ON TABLE stored_bucket IS 'Full buckets of scored vectors, of all runs; read visible_bucket instead';
COMMENT ON COLUMN stored_bucket.version_id IS 'The version';
COMMENT ON COLUMN stored_bucket.bucket_no IS 'Number of the bucket: (number of a scored vector - 1) div stride';
COMMENT ON COLUMN stored_bucket.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_bucket.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_bucket.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_bucket.context_time
  IS 'Time of the oldest sample that decides the next vector: where a restart reads from; -2^62 is everything';
COMMENT ON COLUMN stored_bucket.samples
  IS 'Samples after the previous bucket up to the end of this one, missing ones included';
COMMENT ON COLUMN stored_bucket.novel IS 'Vectors in it whose cell is not in the support';
COMMENT ON COLUMN stored_bucket.out_of_range IS 'Vectors in it with a sample outside the range of calibration';
COMMENT ON COLUMN stored_bucket.novel_in_window
  IS 'Novel vectors in the window that ends with it; NULL until the window is full';
COMMENT ON COLUMN stored_bucket.still
  IS 'Samples after the previous bucket up to the end of this one that stood still; NULL without still_after';
COMMENT ON COLUMN stored_bucket.unknown_program
  IS 'Readings after the previous bucket up to its end of programs that are not judged; NULL without programs';

-- Novel: the cells outside the support that each bucket visited. Rows are visible once their run is
-- recorded; read them through visible_novel.
CREATE TABLE IF NOT EXISTS stored_novel (
  version_id BIGINT NOT NULL,
  bucket_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  cell_key BIGINT NOT NULL,
  visits BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL
);

COMMENT ON TABLE stored_novel IS 'Novel cells of buckets, of all runs; read visible_novel instead';
COMMENT ON COLUMN stored_novel.version_id IS 'The version';
COMMENT ON COLUMN stored_novel.bucket_no IS 'The bucket';
COMMENT ON COLUMN stored_novel.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_novel.cell_key IS 'The cell: its bins on the m axes, as one integer';
COMMENT ON COLUMN stored_novel.visits IS 'Vectors of the bucket in it';
COMMENT ON COLUMN stored_novel.first_time IS 'Time of its first visit in the bucket';
COMMENT ON COLUMN stored_novel.last_time IS 'Time of its last visit in the bucket';

-- Unknown program: what a machine ran that calibration holds too little of, or nothing. It counts from bucket to
-- bucket; rows of the bucket after the last one are of what came since. Read them through visible_program.
CREATE TABLE IF NOT EXISTS stored_unknown_program (
  version_id BIGINT NOT NULL,
  bucket_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  program VARCHAR,
  readings BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL
);

COMMENT ON TABLE stored_unknown_program IS 'Readings of programs that are not judged, of all runs; read visible_program instead';
COMMENT ON COLUMN stored_unknown_program.version_id IS 'The version';
COMMENT ON COLUMN stored_unknown_program.bucket_no
  IS 'The bucket that ends next; the one after the last for readings since';
COMMENT ON COLUMN stored_unknown_program.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_unknown_program.program IS 'What the machine ran; NULL where nothing says so';
COMMENT ON COLUMN stored_unknown_program.readings IS 'Readings that are not missing';
COMMENT ON COLUMN stored_unknown_program.first_time IS 'Time of the first of them';
COMMENT ON COLUMN stored_unknown_program.last_time IS 'Time of the last of them';

-- Run: the record that a version was scored from a bucket on. It is written last and makes the rows of
-- the run visible; rows of earlier runs from that bucket on are hidden.
CREATE TABLE IF NOT EXISTS stored_run (
  run_id BIGINT NOT NULL,
  version_id BIGINT NOT NULL,
  from_bucket BIGINT NOT NULL,
  read_from BIGINT NOT NULL,
  read_to BIGINT,
  rows_read BIGINT NOT NULL,
  context_rows BIGINT NOT NULL,
  context_expected BIGINT,
  calibration_readings BIGINT,
  lookback BIGINT NOT NULL,
  settled_bucket BIGINT,
  settled_time BIGINT,
  settled_context BIGINT,
  started BIGINT NOT NULL,
  committed BIGINT NOT NULL,
  planned_from BIGINT,
  withdrawn BIGINT,
  still_since BIGINT,
  hides BIGINT,
  made_from BIGINT,
  episodes_pending BIGINT
);

COMMENT ON TABLE stored_run IS 'Finished runs of scoring; one row per run and version';
COMMENT ON COLUMN stored_run.run_id IS 'The run; a later one is larger';
COMMENT ON COLUMN stored_run.version_id IS 'The version';
COMMENT ON COLUMN stored_run.from_bucket IS 'First bucket that it wrote anew';
COMMENT ON COLUMN stored_run.read_from IS 'From which time on it read the channel';
COMMENT ON COLUMN stored_run.read_to IS 'Newest time that it read of the channel; NULL if there was no row';
COMMENT ON COLUMN stored_run.rows_read IS 'Rows of the channel that it read';
COMMENT ON COLUMN stored_run.context_rows IS 'Samples it read up to the end of the bucket before made_from';
COMMENT ON COLUMN stored_run.context_expected
  IS 'Samples there were when that bucket was written; NULL for the first bucket';
COMMENT ON COLUMN stored_run.calibration_readings
  IS 'Rows inside calibration, counted again; NULL if this run did not count';
COMMENT ON COLUMN stored_run.lookback
  IS 'How late a row may come, as this run took it, in the unit of time; -1 where the next run adds up what this one read';
COMMENT ON COLUMN stored_run.settled_bucket
  IS 'Last bucket that no such row can change; -1 if there is none, NULL if no row was read';
COMMENT ON COLUMN stored_run.settled_time
  IS 'Time of its last vector: the next run scores what is newer; NULL if there is none';
COMMENT ON COLUMN stored_run.settled_context
  IS 'Its context_time: the next run reads from there; NULL if there is none';
COMMENT ON COLUMN stored_run.started IS 'When it began, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_run.committed IS 'When it was recorded, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_run.planned_from
  IS 'The newest finished run of the version when this one was planned; 0 if there was none';
COMMENT ON COLUMN stored_run.withdrawn
  IS 'In a second row of a run: 1, it gave way to another that was planned from the same; else NULL';
COMMENT ON COLUMN stored_run.still_since
  IS 'Time from which on the signal stood still up to the newest sample read; NULL if it moved, or without still_after';
COMMENT ON COLUMN stored_run.hides IS '0 if no row of an earlier run is left that it hides; NULL where there may be';
COMMENT ON COLUMN stored_run.made_from
  IS 'First bucket that it made of what it read; those before from_bucket are as they were. NULL: it wrote all of them';
COMMENT ON COLUMN stored_run.episodes_pending
  IS '1 where episodes follow its judgements in the next run of gam score: a script ran; else NULL';

-- Unplaced: how many rows of the source a run could give to no channel or instant; the newest row says when the last
-- run was.
CREATE TABLE IF NOT EXISTS stored_unplaced (
  monitor_id BIGINT NOT NULL,
  started BIGINT NOT NULL,
  nameless BIGINT NOT NULL,
  undated BIGINT NOT NULL,
  strangers BIGINT NOT NULL,
  stranger_channels BIGINT NOT NULL,
  held BIGINT,
  invalid BIGINT
);

COMMENT ON TABLE stored_unplaced IS 'Rows that a run could give to no channel or instant; one row per run';
COMMENT ON COLUMN stored_unplaced.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_unplaced.started
  IS 'When the run began, in microseconds since 1970 (UTC); also in its rows of run';
COMMENT ON COLUMN stored_unplaced.nameless IS 'Rows of its range without asset or channel';
COMMENT ON COLUMN stored_unplaced.undated IS 'Rows of the source without a time';
COMMENT ON COLUMN stored_unplaced.strangers IS 'Rows of its range of channels that have no calibration';
COMMENT ON COLUMN stored_unplaced.stranger_channels IS 'How many such channels there were';
COMMENT ON COLUMN stored_unplaced.held
  IS 'Readings of its range that were held to valid_when; NULL where the source has no such condition';
COMMENT ON COLUMN stored_unplaced.invalid IS 'Those of them for which it does not hold, so that they are missing';

-- Checksum: what calibration froze, a second time: integers as sums (sql/stored/calibrating/checksum_rows.sql), all
-- else as it is. Written with the version.
CREATE TABLE IF NOT EXISTS stored_checksum (
  version_id BIGINT NOT NULL,
  cells_sum BIGINT NOT NULL,
  intervals_sum BIGINT NOT NULL,
  figures_sum BIGINT NOT NULL,
  calibrated_lo DOUBLE,
  calibrated_hi DOUBLE,
  target_floor DOUBLE NOT NULL,
  settings_hash VARCHAR NOT NULL,
  method_hash VARCHAR NOT NULL
);

COMMENT ON TABLE stored_checksum
  IS 'What calibration froze, a second time, so that damage is noticed; one row per version';
COMMENT ON COLUMN stored_checksum.version_id IS 'The version';
COMMENT ON COLUMN stored_checksum.cells_sum IS 'Checksum of the cells of its support and their visits';
COMMENT ON COLUMN stored_checksum.intervals_sum IS 'Checksum of the intervals it learnt from';
COMMENT ON COLUMN stored_checksum.figures_sum IS 'Checksum of the integers of the version and of the certificate';
COMMENT ON COLUMN stored_checksum.calibrated_lo IS 'Smallest calibration value; NULL without calibration';
COMMENT ON COLUMN stored_checksum.calibrated_hi IS 'Largest calibration value; NULL without calibration';
COMMENT ON COLUMN stored_checksum.target_floor IS 'Health indicator that a healthy machine may show';
COMMENT ON COLUMN stored_checksum.settings_hash IS 'Hash of the settings it was made under';
COMMENT ON COLUMN stored_checksum.method_hash IS 'Hash of the SQL that learnt it';

-- Horizon: how far back buckets and novel cells are kept of a version; what is older was pruned. Without it,
-- rows that were lost could not be told from rows that were pruned.
CREATE TABLE IF NOT EXISTS stored_horizon (
  version_id BIGINT NOT NULL,
  first_bucket BIGINT NOT NULL,
  first_novel BIGINT NOT NULL
);

COMMENT ON TABLE stored_horizon
  IS 'From where on buckets and novel cells are kept; of each version the largest counts, without a row all';
COMMENT ON COLUMN stored_horizon.version_id IS 'The version';
COMMENT ON COLUMN stored_horizon.first_bucket IS 'First bucket that pruning left';
COMMENT ON COLUMN stored_horizon.first_novel IS 'First bucket of which it left the novel cells';

-- Proof: when the state was compared with what it should be, and what came out.
CREATE TABLE IF NOT EXISTS stored_proof (
  monitor_id BIGINT NOT NULL,
  proved_at BIGINT NOT NULL,
  extent VARCHAR NOT NULL,
  channels BIGINT NOT NULL,
  versions BIGINT NOT NULL,
  buckets BIGINT NOT NULL,
  differences BIGINT NOT NULL
);

COMMENT ON TABLE stored_proof
  IS 'When the state of a monitor was checked, over what, and how many differences there were';
COMMENT ON COLUMN stored_proof.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_proof.proved_at IS 'When the check began, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_proof.extent
  IS 'state: all of it, with the source (gam check --state); checksums: what calibration froze';
COMMENT ON COLUMN stored_proof.channels IS 'Channels that were checked';
COMMENT ON COLUMN stored_proof.versions IS 'Versions that were checked';
COMMENT ON COLUMN stored_proof.buckets IS 'Visible buckets that were checked; 0 for checksums';
COMMENT ON COLUMN stored_proof.differences IS 'Differences that were found';

-- Ladder: the floor of each support on its own grid and on every coarser one that calibration tried.
CREATE TABLE IF NOT EXISTS stored_ladder (
  support_id BIGINT NOT NULL,
  bins BIGINT NOT NULL,
  floor DOUBLE NOT NULL
);

COMMENT ON TABLE stored_ladder
  IS 'Floor of healthy operation by bins per axis; one row per grid of a support';
COMMENT ON COLUMN stored_ladder.support_id IS 'The support';
COMMENT ON COLUMN stored_ladder.bins IS 'Bins per axis: those of the version, then half of them, and so on';
COMMENT ON COLUMN stored_ladder.floor IS 'Expected health indicator of healthy operation on that grid';

-- Buffered: of each block of calibration the vectors in cells that only blocks near it visited; what limits are
-- made of (sql/alarms/buffered.sql).
CREATE TABLE IF NOT EXISTS stored_buffered (
  version_id BIGINT NOT NULL,
  block BIGINT NOT NULL,
  g BIGINT NOT NULL,
  vectors BIGINT NOT NULL,
  novel_buffered BIGINT NOT NULL
);

COMMENT ON TABLE stored_buffered
  IS 'What calibration says of judgements: the blocks of a version, each for three widths; one row per block and width';
COMMENT ON COLUMN stored_buffered.version_id IS 'The version';
COMMENT ON COLUMN stored_buffered.block IS 'Number of the block within its channel, from 0';
COMMENT ON COLUMN stored_buffered.g IS 'Blocks up to so far away do not vouch for a cell';
COMMENT ON COLUMN stored_buffered.vectors IS 'Vectors in the block';
COMMENT ON COLUMN stored_buffered.novel_buffered IS 'Those whose cell no block farther away visited';

-- Extent: how much calibration a version had, and whether it is a fair sample of what follows.
CREATE TABLE IF NOT EXISTS stored_extent (
  version_id BIGINT NOT NULL,
  vectors BIGINT NOT NULL,
  calibration_length BIGINT NOT NULL,
  order_ratio BIGINT
);

COMMENT ON TABLE stored_extent
  IS 'How long the calibration of a version is, and in what order its cells came; one row per version';
COMMENT ON COLUMN stored_extent.version_id IS 'The version';
COMMENT ON COLUMN stored_extent.vectors IS 'Calibration vectors of its own channel';
COMMENT ON COLUMN stored_extent.calibration_length
  IS 'Its intervals summed, in the unit of time; from first to last sample where that is 0';
COMMENT ON COLUMN stored_extent.order_ratio
  IS 'Vectors in cells visited near one time only, by those of random order, in thousandths';

-- Limit: what judgements of a version are judged by, or why they are not. Frozen: a new row replaces an older one
-- from a judgement on.
CREATE TABLE IF NOT EXISTS stored_limit (
  version_id BIGINT NOT NULL,
  limit_no BIGINT NOT NULL,
  from_judgement BIGINT NOT NULL,
  created BIGINT NOT NULL,
  cause VARCHAR NOT NULL,
  asked VARCHAR NOT NULL,
  family BIGINT NOT NULL,
  blocks BIGINT NOT NULL,
  g BIGINT NOT NULL,
  centre BIGINT,
  spread BIGINT,
  reference BIGINT,
  height BIGINT,
  cap BIGINT,
  quarters BIGINT,
  basis VARCHAR,
  order_ratio BIGINT,
  judgements_per_day DOUBLE,
  rate DOUBLE,
  stated_rate DOUBLE,
  reason VARCHAR
);

COMMENT ON TABLE stored_limit
  IS 'What the judgements of a version are judged by; one row per version and time that limits were made';
COMMENT ON COLUMN stored_limit.version_id IS 'The version';
COMMENT ON COLUMN stored_limit.limit_no
  IS '1, 2, ... within the version; the newest that begins at or before a judgement counts';
COMMENT ON COLUMN stored_limit.from_judgement IS 'First judgement that it is for';
COMMENT ON COLUMN stored_limit.created IS 'When it was made, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_limit.cause IS 'Why it was made: calibrated, or what was said then';
COMMENT ON COLUMN stored_limit.asked IS 'The false alarms that were asked for';
COMMENT ON COLUMN stored_limit.family IS 'Channels of the same number were made together, as alike; from 0';
COMMENT ON COLUMN stored_limit.blocks IS 'Blocks of calibration of a window or more';
COMMENT ON COLUMN stored_limit.g IS 'Blocks up to so far away did not vouch for a cell';
COMMENT ON COLUMN stored_limit.centre
  IS 'Mean root of the blocks, in thousandths; NULL where judgements have no limit';
COMMENT ON COLUMN stored_limit.spread IS 'Their standard deviation, likewise';
COMMENT ON COLUMN stored_limit.reference IS 'Root above which a judgement is raised: centre + spread';
COMMENT ON COLUMN stored_limit.height
  IS 'Evidence that opens an episode: 1 where the indicator does, as judgements have no limit; NULL where nothing judges';
COMMENT ON COLUMN stored_limit.cap IS 'The most that one judgement adds to evidence';
COMMENT ON COLUMN stored_limit.quarters IS 'The height in quarters of a spread';
COMMENT ON COLUMN stored_limit.basis
  IS 'What the height rests on: replay, extrapolated, table, drifting or none; indicator: hi_limit, and no rate can be stated';
COMMENT ON COLUMN stored_limit.order_ratio IS 'As in extent; NULL with fewer than 18 blocks';
COMMENT ON COLUMN stored_limit.judgements_per_day
  IS 'Judgements a day in calibration; NULL where the source counts time';
COMMENT ON COLUMN stored_limit.rate IS 'False alarms asked for, per judgement';
COMMENT ON COLUMN stored_limit.stated_rate
  IS 'Those that the height is for, at least 0.0005; NULL where none can be stated';
COMMENT ON COLUMN stored_limit.reason IS 'Why judgements have no limit; NULL where they have one';

-- Judgement: a full window of scored vectors, with what it says. Rows are visible once their run is recorded; read them
-- through visible_judgement.
CREATE TABLE IF NOT EXISTS stored_judgement (
  version_id BIGINT NOT NULL,
  bucket_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  judgement_no BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL,
  novel BIGINT NOT NULL,
  root BIGINT NOT NULL,
  reference BIGINT NOT NULL,
  height BIGINT NOT NULL,
  evidence BIGINT NOT NULL,
  is_open BIGINT NOT NULL,
  last_zero BIGINT
);

COMMENT ON TABLE stored_judgement
  IS 'Judgements of channels that have a limit, of all runs; read visible_judgement instead';
COMMENT ON COLUMN stored_judgement.version_id IS 'The version';
COMMENT ON COLUMN stored_judgement.bucket_no IS 'The bucket that closes it: its last one';
COMMENT ON COLUMN stored_judgement.run_id IS 'The run that wrote that bucket';
COMMENT ON COLUMN stored_judgement.judgement_no IS 'Number of the judgement, from 0';
COMMENT ON COLUMN stored_judgement.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_judgement.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_judgement.novel IS 'Novel vectors in its window';
COMMENT ON COLUMN stored_judgement.root IS 'Square root of that, in thousandths';
COMMENT ON COLUMN stored_judgement.reference IS 'Root above which it is raised';
COMMENT ON COLUMN stored_judgement.height IS 'Evidence that opens an episode';
COMMENT ON COLUMN stored_judgement.evidence IS 'How far roots stood above the reference of late, summed';
COMMENT ON COLUMN stored_judgement.is_open IS '1 if it belongs to an episode, else 0';
COMMENT ON COLUMN stored_judgement.last_zero
  IS 'The latest judgement that an onset cannot lie before: without evidence, or open before this one; NULL if there was none';

-- Episode: the history of what was raised: a row for each time that an episode became known, or other than it was. The
-- newest row of an id counts.
CREATE TABLE IF NOT EXISTS stored_episode (
  monitor_id BIGINT NOT NULL,
  episode_id BIGINT NOT NULL,
  seq BIGINT NOT NULL,
  noticed_at BIGINT NOT NULL,
  what VARCHAR NOT NULL,
  status VARCHAR NOT NULL,
  merged_into BIGINT,
  channel_id BIGINT NOT NULL,
  version_id BIGINT NOT NULL,
  onset BIGINT NOT NULL,
  first_judgement BIGINT NOT NULL,
  last_judgement BIGINT NOT NULL,
  onset_time BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL,
  evidence BIGINT NOT NULL,
  height BIGINT NOT NULL,
  is_proving BIGINT NOT NULL
);

COMMENT ON TABLE stored_episode IS 'History of episodes; one row per change, of which the newest of an episode counts';
COMMENT ON COLUMN stored_episode.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_episode.episode_id IS 'Number of the episode within the monitor, given once';
COMMENT ON COLUMN stored_episode.seq IS 'Number of the change within the monitor; it only grows';
COMMENT ON COLUMN stored_episode.noticed_at IS 'When it was noticed, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_episode.what
  IS 'opened, reopened, ended, merged, withdrawn, recalibrated or labelled; changed where only its extent did';
COMMENT ON COLUMN stored_episode.status IS 'open, ended, merged, withdrawn or recalibrated';
COMMENT ON COLUMN stored_episode.merged_into IS 'The episode that it is a part of; NULL unless merged';
COMMENT ON COLUMN stored_episode.channel_id IS 'The channel';
COMMENT ON COLUMN stored_episode.version_id IS 'The version whose judgements it is made of';
COMMENT ON COLUMN stored_episode.onset IS 'The judgement in which its evidence left 0';
COMMENT ON COLUMN stored_episode.first_judgement IS 'The judgement that opened it';
COMMENT ON COLUMN stored_episode.last_judgement IS 'Its last open judgement';
COMMENT ON COLUMN stored_episode.onset_time IS 'When the judgement of its onset begins';
COMMENT ON COLUMN stored_episode.first_time IS 'When the judgement begins that opened it';
COMMENT ON COLUMN stored_episode.last_time IS 'When its last open judgement ends';
COMMENT ON COLUMN stored_episode.evidence IS 'The highest evidence in it';
COMMENT ON COLUMN stored_episode.height IS 'Evidence that opened it';
COMMENT ON COLUMN stored_episode.is_proving
  IS '1 if it opened within as many judgements as calibration has blocks, else 0';

-- Label: what people said of an episode, or of a machine in an interval of time.
CREATE TABLE IF NOT EXISTS stored_label (
  monitor_id BIGINT NOT NULL,
  label_id BIGINT NOT NULL,
  episode_id BIGINT,
  asset VARCHAR NOT NULL,
  time_from BIGINT NOT NULL,
  time_to BIGINT NOT NULL,
  kind VARCHAR NOT NULL,
  note VARCHAR,
  until BIGINT,
  created BIGINT NOT NULL
);

COMMENT ON TABLE stored_label IS 'What people said of episodes and machines; one row per label';
COMMENT ON COLUMN stored_label.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_label.label_id IS 'Number of the label within the monitor; the newest of an episode counts';
COMMENT ON COLUMN stored_label.episode_id IS 'The episode; NULL where a machine was labelled';
COMMENT ON COLUMN stored_label.asset IS 'The machine';
COMMENT ON COLUMN stored_label.time_from IS 'First instant that it is about';
COMMENT ON COLUMN stored_label.time_to IS 'Last instant that it is about';
COMMENT ON COLUMN stored_label.kind IS 'true_fault, false_alarm, maintenance, new_program, acknowledged or snoozed';
COMMENT ON COLUMN stored_label.note IS 'What was said beside it; NULL if nothing';
COMMENT ON COLUMN stored_label.until IS 'When it ends, in microseconds since 1970 (UTC); NULL if it does not';
COMMENT ON COLUMN stored_label.created IS 'When it was made, in microseconds since 1970 (UTC)';

-- Band: where calibration was, by the newest coordinate, and how much of that stayed near one time (sql/alarms/bands.sql);
-- beside it the novel vectors of an episode say where the signal went.
CREATE TABLE IF NOT EXISTS stored_band (
  version_id BIGINT NOT NULL,
  g BIGINT NOT NULL,
  band BIGINT NOT NULL,
  visits BIGINT NOT NULL,
  novel_buffered BIGINT NOT NULL
);

COMMENT ON TABLE stored_band
  IS 'Where the calibration of a version was: a band holds bins of the newest sample; one row per band and width';
COMMENT ON COLUMN stored_band.version_id IS 'The version';
COMMENT ON COLUMN stored_band.g IS 'Blocks up to so far away do not vouch for a cell';
COMMENT ON COLUMN stored_band.band
  IS '-1 below the range of calibration, 0, 1, ... in it from low to high, 20 (or bins, if they are fewer) above it';
COMMENT ON COLUMN stored_band.visits IS 'Vectors of calibration in it';
COMMENT ON COLUMN stored_band.novel_buffered IS 'Those whose cell no block farther away visited';

-- Band visit: where the signal was in the first five judgements of an episode, by the newest coordinate. A run reads the
-- source again for it. Rows belong to the judgement that a run wrote: of one that was written again they count no more.
CREATE TABLE IF NOT EXISTS stored_band_visit (
  version_id BIGINT NOT NULL,
  judgement_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  band BIGINT NOT NULL,
  visits BIGINT NOT NULL,
  novel BIGINT NOT NULL
);

COMMENT ON TABLE stored_band_visit
  IS 'Where the signal was in the first judgements of an episode; one row per judgement and band, a second one says the same';
COMMENT ON COLUMN stored_band_visit.version_id IS 'The version';
COMMENT ON COLUMN stored_band_visit.judgement_no IS 'Number of the judgement';
COMMENT ON COLUMN stored_band_visit.run_id IS 'The run that wrote the judgement';
COMMENT ON COLUMN stored_band_visit.band
  IS '-1 below the range of calibration, 0, 1, ... in it from low to high, 20 (or bins, if they are fewer) above it';
COMMENT ON COLUMN stored_band_visit.visits
  IS 'Scored vectors in it; 0 where the source no longer holds what was scored';
COMMENT ON COLUMN stored_band_visit.novel IS 'The novel ones of them';

-- Move: what changes of the whole signal would explain of the novelty in the first five judgements of an episode. It is
-- counted in the same pass as band visits, and its rows belong to a judgement likewise.
CREATE TABLE IF NOT EXISTS stored_move (
  version_id BIGINT NOT NULL,
  judgement_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  move_no BIGINT NOT NULL,
  factor DOUBLE NOT NULL,
  displacement DOUBLE NOT NULL,
  vectors BIGINT NOT NULL,
  novel BIGINT NOT NULL,
  regained BIGINT NOT NULL,
  lost BIGINT NOT NULL
);

COMMENT ON TABLE stored_move
  IS 'What a change of the whole signal, x = factor * x + displacement, explains of the first judgements of an episode; one row per judgement and change that could be tried, a second one says the same';
COMMENT ON COLUMN stored_move.version_id IS 'The version';
COMMENT ON COLUMN stored_move.judgement_no IS 'Number of the judgement';
COMMENT ON COLUMN stored_move.run_id IS 'The run that wrote the judgement';
COMMENT ON COLUMN stored_move.move_no
  IS '0 none, always there; 1 shift, 2 scale, 3 both, 4 mirror (both, upside down)';
COMMENT ON COLUMN stored_move.factor IS 'By what usual values of calibration are multiplied to be those of the judgement';
COMMENT ON COLUMN stored_move.displacement IS 'What is added then, in units of the signal';
COMMENT ON COLUMN stored_move.vectors IS 'Scored vectors that have a cell';
COMMENT ON COLUMN stored_move.novel IS 'The novel ones of them';
COMMENT ON COLUMN stored_move.regained IS 'Those of them whose cell is in the support once the change is undone; 0 of move 0';
COMMENT ON COLUMN stored_move.lost IS 'Vectors not novel whose cell is not in the support then; 0 of move 0';

-- Left out: the channels of which the newest run left rows out, and why.
CREATE TABLE IF NOT EXISTS stored_left_out (
  monitor_id BIGINT NOT NULL,
  started BIGINT NOT NULL,
  kind VARCHAR NOT NULL,
  asset VARCHAR,
  channel VARCHAR,
  readings BIGINT NOT NULL,
  latest BIGINT NOT NULL
);

COMMENT ON TABLE stored_left_out
  IS 'Channels of which a run left rows out, one row each; those of the newest run count';
COMMENT ON COLUMN stored_left_out.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_left_out.started
  IS 'When the run began, in microseconds since 1970 (UTC); also in its row of unplaced';
COMMENT ON COLUMN stored_left_out.kind
  IS 'ahead: rows later than now; unknown: rows of a channel that has no calibration; jump: a counter jumped';
COMMENT ON COLUMN stored_left_out.asset IS 'The machine; NULL where its rows name none';
COMMENT ON COLUMN stored_left_out.channel IS 'The signal; NULL where its rows name none';
COMMENT ON COLUMN stored_left_out.readings IS 'Rows that were left out; of a jump, how far it goes';
COMMENT ON COLUMN stored_left_out.latest
  IS 'The latest of their times, in microseconds since 1970 (UTC), or as the counter of the source';
