-- Finished run: the runs that count. One that was withdrawn has a second row that says so, and neither is
-- here.
CREATE OR REPLACE VIEW stored_finished_run AS
SELECT
  run.run_id AS run_id,
  run.version_id AS version_id,
  run.from_bucket AS from_bucket,
  run.read_from AS read_from,
  run.read_to AS read_to,
  run.rows_read AS rows_read,
  run.context_rows AS context_rows,
  run.context_expected AS context_expected,
  run.calibration_readings AS calibration_readings,
  run.lookback AS lookback,
  run.settled_bucket AS settled_bucket,
  run.settled_time AS settled_time,
  run.settled_context AS settled_context,
  run.started AS started,
  run.committed AS committed,
  run.planned_from AS planned_from
FROM stored_run AS run
LEFT JOIN (
  SELECT version_id, run_id, 1 AS hit
  FROM stored_run
  WHERE withdrawn = 1
) AS gone ON gone.version_id = run.version_id AND gone.run_id = run.run_id
WHERE CASE WHEN gone.hit = 1 THEN 1 ELSE 0 END < 1;

COMMENT ON VIEW stored_finished_run IS 'Finished runs of scoring, but those that were withdrawn';
COMMENT ON COLUMN stored_finished_run.run_id IS 'The run; a later one is larger';
COMMENT ON COLUMN stored_finished_run.version_id IS 'The version';
COMMENT ON COLUMN stored_finished_run.from_bucket IS 'First bucket that it wrote anew';
COMMENT ON COLUMN stored_finished_run.read_from IS 'From which time on it read the channel';
COMMENT ON COLUMN stored_finished_run.read_to
  IS 'Newest time that it read of the channel; NULL if there was no row';
COMMENT ON COLUMN stored_finished_run.rows_read IS 'Rows of the channel that it read';
COMMENT ON COLUMN stored_finished_run.context_rows
  IS 'Samples it read up to the end of the bucket before from_bucket';
COMMENT ON COLUMN stored_finished_run.context_expected
  IS 'Samples there were when that bucket was written; NULL for the first bucket';
COMMENT ON COLUMN stored_finished_run.calibration_readings
  IS 'Rows inside calibration, counted again; NULL if this run did not count';
COMMENT ON COLUMN stored_finished_run.lookback
  IS 'How late a row may come, as this run took it, in the unit of time';
COMMENT ON COLUMN stored_finished_run.settled_bucket
  IS 'Last bucket that no such row can change; -1 if there is none, NULL if no row was read';
COMMENT ON COLUMN stored_finished_run.settled_time
  IS 'Time of its last vector: the next run scores what is newer; NULL if there is none';
COMMENT ON COLUMN stored_finished_run.settled_context
  IS 'Its context_time: the next run reads from there; NULL if there is none';
COMMENT ON COLUMN stored_finished_run.started IS 'When it began, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_finished_run.committed
  IS 'When it was recorded, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_finished_run.planned_from
  IS 'The newest finished run of the version when this one was planned; 0 if there was none';

-- Hidden run: from which bucket on the rows of a run are hidden by later ones. A run hides all rows of earlier ones from
-- from_bucket on; only runs that may (hides) are put in order, with those before them.
CREATE OR REPLACE VIEW stored_hidden_run AS
SELECT version_id, run_id, hidden_from
FROM (
  SELECT
    run.version_id AS version_id,
    run.run_id AS run_id,
    CAST(ROW_NUMBER() OVER (PARTITION BY run.version_id ORDER BY run.run_id DESC) AS BIGINT) AS runs_back,
    MIN(run.from_bucket) OVER (
      PARTITION BY run.version_id ORDER BY run.run_id DESC ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING
    ) AS hidden_from
  FROM stored_finished_run AS run
  JOIN (
    SELECT version_id, MAX(run_id) AS newest_id
    FROM stored_run
    WHERE hides IS NULL
    GROUP BY version_id
  ) AS hiding ON hiding.version_id = run.version_id
  WHERE run.run_id <= hiding.newest_id
) AS run_order
WHERE runs_back > 1;

COMMENT ON VIEW stored_hidden_run IS 'Runs of which later ones hide rows';
COMMENT ON COLUMN stored_hidden_run.version_id IS 'The version';
COMMENT ON COLUMN stored_hidden_run.run_id IS 'The run';
COMMENT ON COLUMN stored_hidden_run.hidden_from IS 'First bucket whose rows of this run are hidden';

-- Visible bucket: of each bucket the row of the newest finished run that reached it.
CREATE OR REPLACE VIEW stored_visible_bucket AS
SELECT
  written.version_id AS version_id,
  written.bucket_no AS bucket_no,
  written.run_id AS run_id,
  written.first_time AS first_time,
  written.last_time AS last_time,
  written.context_time AS context_time,
  written.samples AS samples,
  written.novel AS novel,
  written.out_of_range AS out_of_range,
  written.novel_in_window AS novel_in_window
FROM stored_bucket AS written
JOIN stored_finished_run AS finished
  ON finished.version_id = written.version_id AND finished.run_id = written.run_id
LEFT JOIN (
  SELECT version_id, run_id, hidden_from, 1 AS hit
  FROM stored_hidden_run
) AS later ON later.version_id = written.version_id AND later.run_id = written.run_id
WHERE written.bucket_no >= finished.from_bucket
  AND CASE WHEN later.hit = 1 AND written.bucket_no >= later.hidden_from THEN 1 ELSE 0 END = 0;

COMMENT ON VIEW stored_visible_bucket
  IS 'Full buckets of scored vectors: of each the row of the newest finished run that reached it';
COMMENT ON COLUMN stored_visible_bucket.version_id IS 'The version';
COMMENT ON COLUMN stored_visible_bucket.bucket_no
  IS 'Number of the bucket: (number of a scored vector - 1) div stride';
COMMENT ON COLUMN stored_visible_bucket.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_visible_bucket.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_visible_bucket.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_visible_bucket.context_time
  IS 'Time of the oldest sample of the next possible vector: where a restart reads from';
COMMENT ON COLUMN stored_visible_bucket.samples
  IS 'Samples after the previous bucket up to the end of this one, missing ones included';
COMMENT ON COLUMN stored_visible_bucket.novel IS 'Vectors in it whose cell is not in the support';
COMMENT ON COLUMN stored_visible_bucket.out_of_range
  IS 'Vectors in it with a sample outside the range of calibration';
COMMENT ON COLUMN stored_visible_bucket.novel_in_window
  IS 'Novel vectors in the window that ends with it; NULL until the window is full';

-- Visible novel: the novel cells of the rows that visible_bucket shows, by the same rule.
CREATE OR REPLACE VIEW stored_visible_novel AS
SELECT
  written.version_id AS version_id,
  written.bucket_no AS bucket_no,
  written.run_id AS run_id,
  written.cell_key AS cell_key,
  written.visits AS visits,
  written.first_time AS first_time,
  written.last_time AS last_time
FROM stored_novel AS written
JOIN stored_finished_run AS finished
  ON finished.version_id = written.version_id AND finished.run_id = written.run_id
LEFT JOIN (
  SELECT version_id, run_id, hidden_from, 1 AS hit
  FROM stored_hidden_run
) AS later ON later.version_id = written.version_id AND later.run_id = written.run_id
WHERE written.bucket_no >= finished.from_bucket
  AND CASE WHEN later.hit = 1 AND written.bucket_no >= later.hidden_from THEN 1 ELSE 0 END = 0;

COMMENT ON VIEW stored_visible_novel
  IS 'Novel cells of buckets: of each bucket those of the newest finished run that reached it';
COMMENT ON COLUMN stored_visible_novel.version_id IS 'The version';
COMMENT ON COLUMN stored_visible_novel.bucket_no IS 'The bucket';
COMMENT ON COLUMN stored_visible_novel.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_visible_novel.cell_key
  IS 'The cell: its bins on the m axes, as one integer';
COMMENT ON COLUMN stored_visible_novel.visits IS 'Vectors of the bucket in it';
COMMENT ON COLUMN stored_visible_novel.first_time IS 'Time of its first visit in the bucket';
COMMENT ON COLUMN stored_visible_novel.last_time IS 'Time of its last visit in the bucket';

-- Visible program: the readings whose program is not judged, by the same rule as visible_bucket; those of the bucket after
-- the last one came since.
CREATE OR REPLACE VIEW stored_visible_program AS
SELECT
  written.version_id AS version_id,
  written.bucket_no AS bucket_no,
  written.run_id AS run_id,
  written.program AS program,
  written.readings AS readings,
  written.first_time AS first_time,
  written.last_time AS last_time
FROM stored_unknown_program AS written
JOIN stored_finished_run AS finished
  ON finished.version_id = written.version_id AND finished.run_id = written.run_id
LEFT JOIN (
  SELECT version_id, run_id, hidden_from, 1 AS hit
  FROM stored_hidden_run
) AS later ON later.version_id = written.version_id AND later.run_id = written.run_id
WHERE written.bucket_no >= finished.from_bucket
  AND CASE WHEN later.hit = 1 AND written.bucket_no >= later.hidden_from THEN 1 ELSE 0 END = 0;

COMMENT ON VIEW stored_visible_program
  IS 'Readings whose program is not judged: of each bucket those of the newest finished run that reached it';
COMMENT ON COLUMN stored_visible_program.version_id IS 'The version';
COMMENT ON COLUMN stored_visible_program.bucket_no IS 'The bucket that ends next';
COMMENT ON COLUMN stored_visible_program.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_visible_program.program IS 'What the machine ran; NULL where nothing says so';
COMMENT ON COLUMN stored_visible_program.readings IS 'Readings that are not missing';
COMMENT ON COLUMN stored_visible_program.first_time IS 'Time of the first of them';
COMMENT ON COLUMN stored_visible_program.last_time IS 'Time of the last of them';

-- Visible judgement: of each judgement the row of the newest finished run that reached it, by the same rule
-- as visible_bucket.
CREATE OR REPLACE VIEW stored_visible_judgement AS
SELECT
  written.version_id AS version_id,
  written.bucket_no AS bucket_no,
  written.run_id AS run_id,
  written.judgement_no AS judgement_no,
  written.first_time AS first_time,
  written.last_time AS last_time,
  written.novel AS novel,
  written.root AS root,
  written.reference AS reference,
  written.height AS height,
  written.evidence AS evidence,
  written.is_open AS is_open,
  written.last_zero AS last_zero
FROM stored_judgement AS written
JOIN stored_finished_run AS finished
  ON finished.version_id = written.version_id AND finished.run_id = written.run_id
LEFT JOIN (
  SELECT version_id, run_id, hidden_from, 1 AS hit
  FROM stored_hidden_run
) AS later ON later.version_id = written.version_id AND later.run_id = written.run_id
WHERE written.bucket_no >= finished.from_bucket
  AND CASE WHEN later.hit = 1 AND written.bucket_no >= later.hidden_from THEN 1 ELSE 0 END = 0;

COMMENT ON VIEW stored_visible_judgement
  IS 'Judgements of channels that have a limit: of each the row of the newest finished run that reached it';
COMMENT ON COLUMN stored_visible_judgement.version_id IS 'The version';
COMMENT ON COLUMN stored_visible_judgement.bucket_no IS 'The bucket that closes it: its last one';
COMMENT ON COLUMN stored_visible_judgement.run_id IS 'The run that wrote that bucket';
COMMENT ON COLUMN stored_visible_judgement.judgement_no IS 'Number of the judgement, from 0';
COMMENT ON COLUMN stored_visible_judgement.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_visible_judgement.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_visible_judgement.novel IS 'Novel vectors in its window';
COMMENT ON COLUMN stored_visible_judgement.root IS 'Square root of that, in thousandths';
COMMENT ON COLUMN stored_visible_judgement.reference IS 'Root above which it is raised';
COMMENT ON COLUMN stored_visible_judgement.height IS 'Evidence that opens an episode';
COMMENT ON COLUMN stored_visible_judgement.evidence IS 'How far roots stood above the reference of late, summed';
COMMENT ON COLUMN stored_visible_judgement.is_open IS '1 if it belongs to an episode, else 0';
COMMENT ON COLUMN stored_visible_judgement.last_zero
  IS 'The latest judgement that an onset cannot lie before: without evidence, or open before this one; NULL if there was none';

-- Visible episode: what is known of every episode now: its newest row.
CREATE OR REPLACE VIEW stored_visible_episode AS
SELECT
  episode.monitor_id AS monitor_id,
  episode.episode_id AS episode_id,
  episode.seq AS seq,
  episode.noticed_at AS noticed_at,
  episode.what AS what,
  episode.status AS status,
  episode.merged_into AS merged_into,
  episode.channel_id AS channel_id,
  episode.version_id AS version_id,
  episode.onset AS onset,
  episode.first_judgement AS first_judgement,
  episode.last_judgement AS last_judgement,
  episode.onset_time AS onset_time,
  episode.first_time AS first_time,
  episode.last_time AS last_time,
  episode.evidence AS evidence,
  episode.height AS height,
  episode.is_proving AS is_proving
FROM stored_episode AS episode
JOIN (
  SELECT monitor_id, episode_id, MAX(seq) AS newest_seq
  FROM stored_episode
  GROUP BY monitor_id, episode_id
) AS newest ON newest.monitor_id = episode.monitor_id AND newest.newest_seq = episode.seq;

COMMENT ON VIEW stored_visible_episode IS 'Episodes as they are now; one row per episode';
COMMENT ON COLUMN stored_visible_episode.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_visible_episode.episode_id IS 'Number of the episode within the monitor, given once';
COMMENT ON COLUMN stored_visible_episode.seq IS 'Number of the change within the monitor; it only grows';
COMMENT ON COLUMN stored_visible_episode.noticed_at IS 'When it was noticed, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_visible_episode.what
  IS 'opened, reopened, ended, merged, withdrawn, recalibrated or labelled; changed where only its extent did';
COMMENT ON COLUMN stored_visible_episode.status IS 'open, ended, merged, withdrawn or recalibrated';
COMMENT ON COLUMN stored_visible_episode.merged_into IS 'The episode that it is a part of; NULL unless merged';
COMMENT ON COLUMN stored_visible_episode.channel_id IS 'The channel';
COMMENT ON COLUMN stored_visible_episode.version_id IS 'The version whose judgements it is made of';
COMMENT ON COLUMN stored_visible_episode.onset IS 'The judgement in which its evidence left 0';
COMMENT ON COLUMN stored_visible_episode.first_judgement IS 'The judgement that opened it';
COMMENT ON COLUMN stored_visible_episode.last_judgement IS 'Its last open judgement';
COMMENT ON COLUMN stored_visible_episode.onset_time IS 'When the judgement of its onset begins';
COMMENT ON COLUMN stored_visible_episode.first_time IS 'When the judgement begins that opened it';
COMMENT ON COLUMN stored_visible_episode.last_time IS 'When its last open judgement ends';
COMMENT ON COLUMN stored_visible_episode.evidence IS 'The highest evidence in it';
COMMENT ON COLUMN stored_visible_episode.height IS 'Evidence that opened it';
COMMENT ON COLUMN stored_visible_episode.is_proving
  IS '1 if it opened within as many judgements as calibration has blocks, else 0';

-- Labelled episode: every episode as it is now, with the newest of the labels that it, or its machine at that time, was
-- given, and what follows from that: this is the one place that says which episode asks for attention. One that is open
-- does, and one that opened right after calibration until it is decided what it was; not while it is put aside, and after
-- a decision only a true fault that goes on. Now is when the newest run of the monitor was recorded.
CREATE OR REPLACE VIEW stored_labelled_episode AS
SELECT
  labelled.monitor_id AS monitor_id,
  labelled.episode_id AS episode_id,
  labelled.seq AS seq,
  labelled.noticed_at AS noticed_at,
  labelled.what AS what,
  labelled.status AS status,
  labelled.merged_into AS merged_into,
  labelled.channel_id AS channel_id,
  labelled.version_id AS version_id,
  labelled.onset AS onset,
  labelled.first_judgement AS first_judgement,
  labelled.last_judgement AS last_judgement,
  labelled.onset_time AS onset_time,
  labelled.first_time AS first_time,
  labelled.last_time AS last_time,
  labelled.evidence AS evidence,
  labelled.height AS height,
  labelled.is_proving AS is_proving,
  labelled.label AS label,
  labelled.label_until AS label_until,
  labelled.note AS note,
  CASE
    WHEN labelled.status = 'open' AND labelled.height = 1 THEN 'high'
    WHEN labelled.status IN ('merged', 'withdrawn', 'recalibrated') OR labelled.is_proving = 0 THEN labelled.status
    WHEN labelled.label IN ('true_fault', 'false_alarm', 'maintenance', 'new_program') THEN labelled.status
    ELSE 'proving'
  END AS told_as,
  CASE
    WHEN labelled.status IN ('merged', 'withdrawn', 'recalibrated') THEN 0
    WHEN labelled.label IN ('acknowledged', 'snoozed')
      AND (labelled.label_until IS NULL OR labelled.label_until > labelled.now_tick)
      THEN 0
    WHEN labelled.label IN ('false_alarm', 'maintenance', 'new_program') THEN 0
    WHEN labelled.status = 'open' THEN 1
    WHEN labelled.label = 'true_fault' THEN 0
    ELSE labelled.is_proving
  END AS needs_attention
FROM (
  SELECT
    episode.monitor_id AS monitor_id,
    episode.episode_id AS episode_id,
    episode.seq AS seq,
    episode.noticed_at AS noticed_at,
    episode.what AS what,
    episode.status AS status,
    episode.merged_into AS merged_into,
    episode.channel_id AS channel_id,
    episode.version_id AS version_id,
    episode.onset AS onset,
    episode.first_judgement AS first_judgement,
    episode.last_judgement AS last_judgement,
    episode.onset_time AS onset_time,
    episode.first_time AS first_time,
    episode.last_time AS last_time,
    episode.evidence AS evidence,
    episode.height AS height,
    episode.is_proving AS is_proving,
    CASE WHEN label_row.hit = 1 THEN label_row.kind END AS label,
    CASE WHEN label_row.hit = 1 THEN label_row.until END AS label_until,
    CASE WHEN label_row.hit = 1 THEN label_row.note END AS note,
    CASE WHEN heard.hit = 1 THEN heard.committed ELSE 0 END AS now_tick
  FROM stored_visible_episode AS episode
  LEFT JOIN (
    SELECT
      raised.monitor_id AS monitor_id,
      raised.episode_id AS episode_id,
      word.kind AS kind,
      word.until AS until,
      word.note AS note,
      CAST(
        ROW_NUMBER() OVER (
          PARTITION BY raised.monitor_id, raised.episode_id ORDER BY word.label_id DESC
        ) AS BIGINT
      ) AS labels_back,
      1 AS hit
    FROM stored_visible_episode AS raised
    JOIN stored_channel AS owner ON owner.channel_id = raised.channel_id
    JOIN stored_label AS word ON word.monitor_id = raised.monitor_id AND word.asset = owner.asset
    WHERE word.episode_id = raised.episode_id
      OR (
        word.episode_id IS NULL
        AND word.time_from <= raised.last_time
        AND word.time_to >= raised.first_time
      )
  ) AS label_row
    ON label_row.monitor_id = episode.monitor_id
    AND label_row.episode_id = episode.episode_id
    AND label_row.labels_back = 1
  LEFT JOIN (
    SELECT reader.monitor_id AS monitor_id, MAX(done.committed) AS committed, 1 AS hit
    FROM stored_finished_run AS done
    JOIN stored_version AS version ON version.version_id = done.version_id
    JOIN stored_channel AS reader ON reader.channel_id = version.channel_id
    GROUP BY reader.monitor_id
  ) AS heard ON heard.monitor_id = episode.monitor_id
) AS labelled;

COMMENT ON VIEW stored_labelled_episode
  IS 'Episodes as they are now, with what was said of them and whether they need attention; one row per episode';
COMMENT ON COLUMN stored_labelled_episode.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_labelled_episode.episode_id IS 'Number of the episode within the monitor, given once';
COMMENT ON COLUMN stored_labelled_episode.seq IS 'Number of the change within the monitor; it only grows';
COMMENT ON COLUMN stored_labelled_episode.noticed_at IS 'When it was noticed, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_labelled_episode.what
  IS 'opened, reopened, ended, merged, withdrawn, recalibrated or labelled; changed where only its extent did';
COMMENT ON COLUMN stored_labelled_episode.status IS 'open, ended, merged, withdrawn or recalibrated';
COMMENT ON COLUMN stored_labelled_episode.merged_into IS 'The episode that it is a part of; NULL unless merged';
COMMENT ON COLUMN stored_labelled_episode.channel_id IS 'The channel';
COMMENT ON COLUMN stored_labelled_episode.version_id IS 'The version whose judgements it is made of';
COMMENT ON COLUMN stored_labelled_episode.onset IS 'The judgement in which its evidence left 0';
COMMENT ON COLUMN stored_labelled_episode.first_judgement IS 'The judgement that opened it';
COMMENT ON COLUMN stored_labelled_episode.last_judgement IS 'Its last open judgement';
COMMENT ON COLUMN stored_labelled_episode.onset_time IS 'When the judgement of its onset begins';
COMMENT ON COLUMN stored_labelled_episode.first_time IS 'When the judgement begins that opened it';
COMMENT ON COLUMN stored_labelled_episode.last_time IS 'When its last open judgement ends';
COMMENT ON COLUMN stored_labelled_episode.evidence IS 'The highest evidence in it';
COMMENT ON COLUMN stored_labelled_episode.height IS 'Evidence that opened it';
COMMENT ON COLUMN stored_labelled_episode.is_proving
  IS '1 if it opened within as many judgements as calibration has blocks, else 0';
COMMENT ON COLUMN stored_labelled_episode.label
  IS 'What people said last of it: true_fault, false_alarm, maintenance, new_program, acknowledged or snoozed; NULL if nothing';
COMMENT ON COLUMN stored_labelled_episode.label_until
  IS 'When that ends, in microseconds since 1970 (UTC); NULL if it does not';
COMMENT ON COLUMN stored_labelled_episode.note IS 'What was said beside it';
COMMENT ON COLUMN stored_labelled_episode.told_as
  IS 'proving while it opened right after calibration and nobody decided what it was, high while it is open and its indicator opened it, else its status';
COMMENT ON COLUMN stored_labelled_episode.needs_attention
  IS '1 if somebody should look at it, as of the newest run; else 0';

-- Certified: what calibration says of each version, both sides of it, with the limit of its health indicator
-- (judgement/hi_limit.sql). A member of a pool that taught nothing has the certificate of whole machines.
CREATE OR REPLACE VIEW stored_certified AS
SELECT
  version_id,
  verdict,
  floor,
  floor_sd,
  floor_max,
  finest_bins,
  vectors_needed,
  calibration_vectors,
  cells,
  calibrated_lo,
  calibrated_hi,
  sees,
  sees_half_stroke,
  sees_frozen,
  sees_faster,
  sees_slower,
  would_not_see,
  blind_reason,
  vouched_by,
  taught_by,
  member_floor,
  CASE
    WHEN verdict IN ('ready', 'blind')
      THEN CASE
        WHEN floor IS NULL OR floor_max IS NULL THEN NULL
        WHEN 2 * floor >= floor_max AND 2 * floor >= target_floor THEN 2 * floor
        WHEN floor_max >= target_floor THEN floor_max
        ELSE target_floor
      END
  END AS hi_limit
FROM (
  SELECT
    version.version_id AS version_id,
    version.target_floor AS target_floor,
    CASE WHEN others.hit = 1 THEN learnt.member_verdict ELSE learnt.verdict END AS verdict,
    CASE WHEN others.hit = 1 THEN learnt.member_floor ELSE learnt.floor END AS floor,
    CASE WHEN others.hit = 1 THEN learnt.member_floor_sd ELSE learnt.floor_sd END AS floor_sd,
    CASE WHEN others.hit = 1 THEN learnt.member_floor_max ELSE learnt.floor_max END AS floor_max,
    CASE WHEN others.hit = 1 THEN learnt.member_finest_bins ELSE learnt.finest_bins END AS finest_bins,
    CASE
      WHEN others.hit = 1 AND learnt.member_verdict <> 'ready' AND learnt.member_verdict <> 'blind' THEN NULL
      WHEN others.hit = 1 THEN 0
      ELSE learnt.vectors_needed
    END AS vectors_needed,
    learnt.calibration_vectors AS calibration_vectors,
    learnt.cells AS cells,
    learnt.calibrated_lo AS calibrated_lo,
    learnt.calibrated_hi AS calibrated_hi,
    learnt.sees AS sees,
    learnt.sees_half_stroke AS sees_half_stroke,
    learnt.sees_frozen AS sees_frozen,
    learnt.sees_faster AS sees_faster,
    learnt.sees_slower AS sees_slower,
    learnt.would_not_see AS would_not_see,
    learnt.blind_reason AS blind_reason,
    CASE WHEN others.hit = 1 THEN learnt.teachers END AS vouched_by,
    learnt.taught_by AS taught_by,
    learnt.member_floor AS member_floor
  FROM stored_version AS version
  JOIN stored_bounds AS learnt ON learnt.support_id = version.support_id
  LEFT JOIN (
    SELECT member.version_id AS version_id, 1 AS hit
    FROM stored_version AS member
    JOIN stored_bounds AS pool ON pool.support_id = member.support_id
    LEFT JOIN (
      SELECT support_id, channel_id, 1 AS hit
      FROM stored_block
      GROUP BY support_id, channel_id
    ) AS taught ON taught.support_id = member.support_id AND taught.channel_id = member.channel_id
    WHERE pool.member_verdict IS NOT NULL AND CASE WHEN taught.hit = 1 THEN 1 ELSE 0 END < 1
  ) AS others ON others.version_id = version.version_id
) AS learnt;

COMMENT ON VIEW stored_certified IS 'What calibration says of each version';
COMMENT ON COLUMN stored_certified.version_id IS 'The version';
COMMENT ON COLUMN stored_certified.verdict
  IS 'ready, blind, too_fine, needs_data, not_vouched, constant or no_data';
COMMENT ON COLUMN stored_certified.floor
  IS 'Health indicator to expect of healthy operation; NULL if there are too few blocks';
COMMENT ON COLUMN stored_certified.floor_sd
  IS 'Standard deviation of the blocks around it; NULL likewise';
COMMENT ON COLUMN stored_certified.floor_max IS 'Highest block of calibration; NULL likewise';
COMMENT ON COLUMN stored_certified.finest_bins IS 'Finest bins that meet the target; NULL if none do';
COMMENT ON COLUMN stored_certified.vectors_needed
  IS 'Estimate of the further calibration vectors needed; 0 if none, NULL if unknown';
COMMENT ON COLUMN stored_certified.calibration_vectors IS 'Vectors that its support was learnt from';
COMMENT ON COLUMN stored_certified.cells IS 'Cells that they visited';
COMMENT ON COLUMN stored_certified.calibrated_lo IS 'Smallest calibration value inside the range';
COMMENT ON COLUMN stored_certified.calibrated_hi IS 'Largest one';
COMMENT ON COLUMN stored_certified.sees
  IS 'Smallest shift that its indicator would show both ways, in percent of the usual width, if the machine works as in calibration; NULL if none of 1 to 50 %';
COMMENT ON COLUMN stored_certified.sees_half_stroke
  IS '1 if its indicator would show a stroke half as long, 0 if not; NULL if that could not be tried';
COMMENT ON COLUMN stored_certified.sees_frozen IS 'The same of a sensor that gives one value only';
COMMENT ON COLUMN stored_certified.sees_faster IS 'The same of a machine 1.5 times as fast';
COMMENT ON COLUMN stored_certified.sees_slower IS 'The same of a machine at two thirds of its speed';
COMMENT ON COLUMN stored_certified.would_not_see
  IS 'What of a frozen sensor, half a stroke and another speed its indicator would not show, in words; NULL if nothing is known not to';
COMMENT ON COLUMN stored_certified.blind_reason
  IS 'Why no shift would be seen: range, blocks, cells or delay (docs/sight.md); NULL where the verdict is not blind';
COMMENT ON COLUMN stored_certified.vouched_by
  IS 'Machines of its pool that vouch for it, where it taught nothing; NULL else';
COMMENT ON COLUMN stored_certified.taught_by
  IS 'The machines that taught its pool, in words; NULL for a channel that stands alone, or where nobody taught';
COMMENT ON COLUMN stored_certified.member_floor
  IS 'Health indicator to expect of a whole machine of its pool, by leaving out one that taught after another; NULL where less than two taught';
COMMENT ON COLUMN stored_certified.hi_limit
  IS 'Health indicator above which the channel is high; NULL where nothing is to be judged';
