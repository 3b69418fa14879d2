-- Alarm: every episode as it is now, for people, with what was said of it, what its limit promises, and which signals of
-- its machine opened with it. Openings that are no more than two judgements apart belong together, one after the other.
-- A judgement of W vectors lasts W / (n W - 1) of the time from the first to the last vector of n judgements; two are
-- told from three by two and a half.
CREATE OR REPLACE VIEW stored_alarm AS
SELECT
  watching.name AS monitor,
  kept.episode_id AS episode_id,
  named.asset AS asset,
  named.channel AS channel,
  kept.status AS status,
  kept.is_proving AS is_proving,
  kept.told_as AS told_as,
  kept.needs_attention AS needs_attention,
  kept.label AS label,
  kept.label_until AS label_until,
  kept.note AS note,
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
  kept.channel_id AS channel_id,
  CASE WHEN grouped.hit = 1 THEN grouped.group_id END AS group_id,
  CASE WHEN grouped.hit = 1 THEN grouped.signals ELSE 0 END AS signals_together
FROM stored_labelled_episode AS kept
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
    owner.asset AS asset,
    CAST(COUNT(*) AS BIGINT) AS signals,
    1 AS hit
  FROM stored_visible_episode AS raised
  JOIN stored_channel AS owner ON owner.channel_id = raised.channel_id
  WHERE raised.status = 'open'
  GROUP BY raised.monitor_id, owner.asset
) AS beside ON beside.monitor_id = kept.monitor_id AND beside.asset = named.asset
LEFT JOIN (
  SELECT
    counted.monitor_id AS monitor_id,
    counted.episode_id AS episode_id,
    MIN(counted.episode_id) OVER (
      PARTITION BY counted.monitor_id, counted.asset, counted.group_no
    ) AS group_id,
    CAST(COUNT(*) OVER (PARTITION BY counted.monitor_id, counted.asset, counted.group_no) AS BIGINT) AS signals,
    1 AS hit
  FROM (
    SELECT
      begun.monitor_id AS monitor_id,
      begun.asset AS asset,
      begun.episode_id AS episode_id,
      CAST(
        SUM(begun.is_first) OVER (
          PARTITION BY begun.monitor_id, begun.asset
          ORDER BY begun.first_time, begun.episode_id
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS group_no
    FROM (
      SELECT
        opening.monitor_id AS monitor_id,
        opening.asset AS asset,
        opening.episode_id AS episode_id,
        opening.first_time AS first_time,
        CASE
          WHEN CAST(opening.first_time AS DOUBLE)
            <= LAG(CASE WHEN opening.window_length > 0 THEN opening.until END, 1) OVER (
              PARTITION BY opening.monitor_id, opening.asset ORDER BY opening.first_time, opening.episode_id
            ) THEN 0
          ELSE 1
        END AS is_first
      FROM (
        SELECT
          raised.monitor_id AS monitor_id,
          owner.asset AS asset,
          raised.episode_id AS episode_id,
          raised.first_time AS first_time,
          made.window_length AS window_length,
          CAST(raised.first_time AS DOUBLE)
          + CAST(5 AS DOUBLE) * CAST(raised.last_time - raised.first_time AS DOUBLE) * CAST(made.window_length AS DOUBLE)
            / CAST(
              2 * (raised.last_judgement - raised.first_judgement + 1) * made.window_length
              - CASE WHEN made.window_length > 1 THEN 2 ELSE 0 END AS DOUBLE
            ) AS until
        FROM stored_visible_episode AS raised
        JOIN stored_channel AS owner ON owner.channel_id = raised.channel_id
        JOIN stored_version AS made ON made.version_id = raised.version_id
        WHERE raised.status <> 'merged' AND raised.status <> 'withdrawn'
      ) AS opening
    ) AS begun
  ) AS counted
) AS grouped ON grouped.monitor_id = kept.monitor_id AND grouped.episode_id = kept.episode_id;

COMMENT ON VIEW stored_alarm IS 'Episodes as they are now, for people; one row per episode';
COMMENT ON COLUMN stored_alarm.monitor IS 'The monitor';
COMMENT ON COLUMN stored_alarm.episode_id IS 'Number of the episode, given once';
COMMENT ON COLUMN stored_alarm.asset IS 'The machine';
COMMENT ON COLUMN stored_alarm.channel IS 'The signal';
COMMENT ON COLUMN stored_alarm.status
  IS 'open: it goes on; ended; merged: a part of merged_into; withdrawn: data that came later took it back; recalibrated: ended by a new calibration';
COMMENT ON COLUMN stored_alarm.is_proving
  IS '1 if it opened within as many judgements as calibration has blocks: it asks for a decision; else 0';
COMMENT ON COLUMN stored_alarm.told_as IS 'proving while it asks for that decision, else its status';
COMMENT ON COLUMN stored_alarm.needs_attention
  IS '1 if somebody should look at it, as of the newest run; else 0';
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
COMMENT ON COLUMN stored_alarm.group_id
  IS 'Smallest number of the episodes of its machine that opened within two judgements of one another; NULL if it is merged or withdrawn';
COMMENT ON COLUMN stored_alarm.signals_together IS 'How many these are; 1 if it opened alone';
