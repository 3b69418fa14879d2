-- Labelled episode: every episode as it is now, with the newest of the labels that it, or its machine at that time, was
-- given, and what follows from that: this is the one place that says which episode asks for attention. One that is open
-- does, and one that opened right after calibration until it is decided what it was; not while it is put aside, and after
-- a decision only a true fault that goes on. Now is when the newest run of the monitor was recorded.
CREATE OR REPLACE VIEW stored_labelled_episode AS
SELECT
  said.monitor_id AS monitor_id,
  said.episode_id AS episode_id,
  said.seq AS seq,
  said.noticed_at AS noticed_at,
  said.what AS what,
  said.status AS status,
  said.merged_into AS merged_into,
  said.channel_id AS channel_id,
  said.version_id AS version_id,
  said.onset AS onset,
  said.first_judgement AS first_judgement,
  said.last_judgement AS last_judgement,
  said.onset_time AS onset_time,
  said.first_time AS first_time,
  said.last_time AS last_time,
  said.evidence AS evidence,
  said.height AS height,
  said.is_proving AS is_proving,
  said.label AS label,
  said.label_until AS label_until,
  said.note AS note,
  CASE
    WHEN said.status IN ('merged', 'withdrawn', 'recalibrated') OR said.is_proving = 0 THEN said.status
    WHEN said.label IN ('true_fault', 'false_alarm', 'maintenance', 'new_program') THEN said.status
    ELSE 'proving'
  END AS told_as,
  CASE
    WHEN said.status IN ('merged', 'withdrawn', 'recalibrated') THEN 0
    WHEN said.label IN ('acknowledged', 'snoozed') AND (said.label_until IS NULL OR said.label_until > said.now_tick) THEN 0
    WHEN said.label IN ('false_alarm', 'maintenance', 'new_program') THEN 0
    WHEN said.status = 'open' THEN 1
    WHEN said.label = 'true_fault' THEN 0
    ELSE said.is_proving
  END AS needs_attention
FROM (
  SELECT
    kept.monitor_id AS monitor_id,
    kept.episode_id AS episode_id,
    kept.seq AS seq,
    kept.noticed_at AS noticed_at,
    kept.what AS what,
    kept.status AS status,
    kept.merged_into AS merged_into,
    kept.channel_id AS channel_id,
    kept.version_id AS version_id,
    kept.onset AS onset,
    kept.first_judgement AS first_judgement,
    kept.last_judgement AS last_judgement,
    kept.onset_time AS onset_time,
    kept.first_time AS first_time,
    kept.last_time AS last_time,
    kept.evidence AS evidence,
    kept.height AS height,
    kept.is_proving AS is_proving,
    CASE WHEN given.hit = 1 THEN given.kind END AS label,
    CASE WHEN given.hit = 1 THEN given.until END AS label_until,
    CASE WHEN given.hit = 1 THEN given.note END AS note,
    CASE WHEN heard.hit = 1 THEN heard.committed ELSE 0 END AS now_tick
  FROM stored_visible_episode AS kept
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
  ) AS given
    ON given.monitor_id = kept.monitor_id
    AND given.episode_id = kept.episode_id
    AND given.labels_back = 1
  LEFT JOIN (
    SELECT reader.monitor_id AS monitor_id, MAX(done.committed) AS committed, 1 AS hit
    FROM stored_finished_run AS done
    JOIN stored_version AS made ON made.version_id = done.version_id
    JOIN stored_channel AS reader ON reader.channel_id = made.channel_id
    GROUP BY reader.monitor_id
  ) AS heard ON heard.monitor_id = kept.monitor_id
) AS said;

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
  IS 'proving while it opened right after calibration and nobody decided what it was, else its status';
COMMENT ON COLUMN stored_labelled_episode.needs_attention
  IS '1 if somebody should look at it, as of the newest run; else 0';
