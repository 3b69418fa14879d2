-- Alarm: every episode as it is now, for people, with the newest of the labels that it, or its machine at that time, was
-- given, and what its limit promises.
CREATE OR REPLACE VIEW stored_alarm AS
SELECT
  watching.name AS monitor,
  kept.episode_id AS episode_id,
  named.asset AS asset,
  named.channel AS channel,
  kept.status AS status,
  kept.is_proving AS is_proving,
  CASE WHEN given.hit = 1 THEN given.kind END AS label,
  CASE WHEN given.hit = 1 THEN given.until END AS label_until,
  CASE WHEN given.hit = 1 THEN given.note END AS note,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(kept.onset_time) END AS since_time,
  kept.onset_time AS since_tick,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(kept.first_time) END AS first_time,
  kept.first_time AS first_tick,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(kept.last_time) END AS last_time,
  kept.last_time AS last_tick,
  kept.onset AS onset,
  kept.first_judgement AS first_judgement,
  kept.last_judgement AS last_judgement,
  kept.evidence AS evidence,
  kept.height AS height,
  CASE WHEN promised.hit = 1 THEN promised.basis END AS basis,
  CASE WHEN promised.hit = 1 THEN promised.asked END AS asked,
  CASE WHEN promised.hit = 1 THEN promised.stated_rate END AS stated_rate,
  CASE WHEN beside.hit = 1 THEN beside.signals ELSE 0 END AS signals_open,
  kept.merged_into AS merged_into,
  kept.seq AS seq,
  kept.version_id AS version_id,
  kept.channel_id AS channel_id
FROM stored_visible_episode AS kept
JOIN stored_monitor AS watching ON watching.monitor_id = kept.monitor_id
JOIN stored_channel AS named ON named.channel_id = kept.channel_id
LEFT JOIN (
  SELECT
    raised.monitor_id AS monitor_id,
    raised.episode_id AS episode_id,
    made.basis AS basis,
    made.asked AS asked,
    made.stated_rate AS stated_rate,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY raised.monitor_id, raised.episode_id ORDER BY made.limit_no DESC
      ) AS BIGINT
    ) AS limits_back,
    1 AS hit
  FROM stored_visible_episode AS raised
  JOIN stored_limit AS made
    ON made.version_id = raised.version_id AND made.from_judgement <= raised.first_judgement
) AS promised
  ON promised.monitor_id = kept.monitor_id
  AND promised.episode_id = kept.episode_id
  AND promised.limits_back = 1
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
  SELECT
    raised.monitor_id AS monitor_id,
    owner.asset AS asset,
    CAST(COUNT(*) AS BIGINT) AS signals,
    1 AS hit
  FROM stored_visible_episode AS raised
  JOIN stored_channel AS owner ON owner.channel_id = raised.channel_id
  WHERE raised.status = 'open'
  GROUP BY raised.monitor_id, owner.asset
) AS beside ON beside.monitor_id = kept.monitor_id AND beside.asset = named.asset;

COMMENT ON VIEW stored_alarm IS 'Episodes as they are now, for people; one row per episode';
COMMENT ON COLUMN stored_alarm.monitor IS 'The monitor';
COMMENT ON COLUMN stored_alarm.episode_id IS 'Number of the episode, given once';
COMMENT ON COLUMN stored_alarm.asset IS 'The machine';
COMMENT ON COLUMN stored_alarm.channel IS 'The signal';
COMMENT ON COLUMN stored_alarm.status
  IS 'open: it goes on; ended; merged: a part of merged_into; withdrawn: data that came later took it back; recalibrated: ended by a new calibration';
COMMENT ON COLUMN stored_alarm.is_proving
  IS '1 if it opened within as many judgements as calibration has blocks: it asks for a decision; else 0';
COMMENT ON COLUMN stored_alarm.label
  IS 'What people said last of it: true_fault, false_alarm, maintenance, new_program, acknowledged or snoozed; NULL if nothing';
COMMENT ON COLUMN stored_alarm.label_until IS 'When that ends, in microseconds since 1970 (UTC); NULL if it does not';
COMMENT ON COLUMN stored_alarm.note IS 'What was said beside it';
COMMENT ON COLUMN stored_alarm.since_time
  IS 'When the judgement begins in which evidence left 0 (UTC); NULL where the source counts time';
COMMENT ON COLUMN stored_alarm.since_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
COMMENT ON COLUMN stored_alarm.first_time
  IS 'When the judgement begins that opened it (UTC); NULL where the source counts time';
COMMENT ON COLUMN stored_alarm.first_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
COMMENT ON COLUMN stored_alarm.last_time
  IS 'When its last open judgement ends (UTC); NULL where the source counts time';
COMMENT ON COLUMN stored_alarm.last_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
COMMENT ON COLUMN stored_alarm.onset IS 'Number of the judgement in which evidence left 0';
COMMENT ON COLUMN stored_alarm.first_judgement IS 'Number of the one that opened it';
COMMENT ON COLUMN stored_alarm.last_judgement IS 'Number of its last open one';
COMMENT ON COLUMN stored_alarm.evidence IS 'The highest evidence in it: how sure';
COMMENT ON COLUMN stored_alarm.height IS 'Evidence that opened it';
COMMENT ON COLUMN stored_alarm.basis
  IS 'What the rate of false alarms rests on: replay, extrapolated, table, drifting or none';
COMMENT ON COLUMN stored_alarm.asked IS 'The false alarms that were asked for';
COMMENT ON COLUMN stored_alarm.stated_rate
  IS 'False alarms that its limit is for, per judgement; NULL where none can be stated';
COMMENT ON COLUMN stored_alarm.signals_open IS 'Signals of its machine that are open now';
COMMENT ON COLUMN stored_alarm.merged_into IS 'The episode that it is a part of; NULL unless merged';
COMMENT ON COLUMN stored_alarm.seq IS 'Number of its newest change';
COMMENT ON COLUMN stored_alarm.version_id IS 'The version whose judgements it is made of';
COMMENT ON COLUMN stored_alarm.channel_id IS 'The channel';
