-- Alarm: every episode as it is now, for people, with what was said of it, what its limit promises, and which signals of
-- its machine opened with it: openings that are no more than two judgements of the slower signal apart, one after the
-- other, are one incident.
-- A judgement of W vectors lasts W / (n W - 1) of the time from the first to the last vector of n judgements; two are
-- told from three by two and a half.
CREATE OR REPLACE VIEW stored_alarm AS
SELECT
  watching.name AS monitor,
  episode.episode_id AS episode_id,
  named.asset AS asset,
  named.channel AS channel,
  episode.status AS status,
  episode.is_proving AS is_proving,
  episode.told_as AS told_as,
  episode.needs_attention AS needs_attention,
  episode.label AS label,
  episode.label_until AS label_until,
  episode.note AS note,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(episode.onset_time) END AS since_time,
  episode.onset_time AS since_tick,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(episode.first_time) END AS first_time,
  episode.first_time AS first_tick,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(episode.last_time) END AS last_time,
  episode.last_time AS last_tick,
  episode.onset AS onset,
  episode.first_judgement AS first_judgement,
  episode.last_judgement AS last_judgement,
  episode.evidence AS evidence,
  episode.height AS height,
  CASE WHEN promised.hit = 1 THEN promised.basis END AS basis,
  CASE WHEN promised.hit = 1 THEN promised.asked END AS asked,
  CASE WHEN promised.hit = 1 THEN promised.stated_rate END AS stated_rate,
  CASE WHEN beside.hit = 1 THEN beside.signals ELSE 0 END AS signals_open,
  episode.merged_into AS merged_into,
  episode.seq AS seq,
  episode.version_id AS version_id,
  episode.channel_id AS channel_id,
  CASE WHEN grouped.hit = 1 THEN grouped.incident_id END AS incident_id,
  CASE WHEN grouped.hit = 1 THEN grouped.signals ELSE 0 END AS signals_together
FROM stored_labelled_episode AS episode
JOIN stored_monitor AS watching ON watching.monitor_id = episode.monitor_id
JOIN stored_channel AS named ON named.channel_id = episode.channel_id
LEFT JOIN (
  SELECT
    raised.monitor_id AS monitor_id,
    raised.episode_id AS episode_id,
    version.basis AS basis,
    version.asked AS asked,
    version.stated_rate AS stated_rate,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY raised.monitor_id, raised.episode_id ORDER BY version.limit_no DESC
      ) AS BIGINT
    ) AS limits_back,
    1 AS hit
  FROM stored_visible_episode AS raised
  JOIN stored_limit AS version
    ON version.version_id = raised.version_id AND version.from_judgement <= raised.first_judgement
) AS promised
  ON promised.monitor_id = episode.monitor_id
  AND promised.episode_id = episode.episode_id
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
) AS beside ON beside.monitor_id = episode.monitor_id AND beside.asset = named.asset
LEFT JOIN (
  SELECT
    counted.monitor_id AS monitor_id,
    counted.episode_id AS episode_id,
    MIN(counted.episode_id) OVER (
      PARTITION BY counted.monitor_id, counted.asset, counted.group_no
    ) AS incident_id,
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
            <= MAX(
              CASE
                WHEN opening.two_judgements >= 0 THEN CAST(opening.first_time AS DOUBLE) + opening.two_judgements
              END
            ) OVER (
              PARTITION BY opening.monitor_id, opening.asset
              ORDER BY opening.first_time, opening.episode_id
              ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING
            ) THEN 0
          WHEN CAST(opening.first_time AS DOUBLE) - opening.two_judgements
            <= LAG(CASE WHEN opening.two_judgements >= 0 THEN CAST(opening.first_time AS DOUBLE) END, 1) OVER (
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
          CAST(5 AS DOUBLE) * CAST(raised.last_time - raised.first_time AS DOUBLE)
            * CAST(version.window_length AS DOUBLE)
            / CAST(
              2 * (raised.last_judgement - raised.first_judgement + 1) * version.window_length
              - CASE WHEN version.window_length > 1 THEN 2 ELSE 0 END AS DOUBLE
            ) AS two_judgements
        FROM stored_visible_episode AS raised
        JOIN stored_channel AS owner ON owner.channel_id = raised.channel_id
        JOIN stored_version AS version ON version.version_id = raised.version_id
        WHERE raised.status <> 'merged' AND raised.status <> 'withdrawn'
      ) AS opening
    ) AS begun
  ) AS counted
) AS grouped ON grouped.monitor_id = episode.monitor_id AND grouped.episode_id = episode.episode_id;

COMMENT ON VIEW stored_alarm IS 'Episodes as they are now, for people; one row per episode';
COMMENT ON COLUMN stored_alarm.monitor IS 'The monitor';
COMMENT ON COLUMN stored_alarm.episode_id IS 'Number of the episode, given once';
COMMENT ON COLUMN stored_alarm.asset IS 'The machine';
COMMENT ON COLUMN stored_alarm.channel IS 'The signal';
COMMENT ON COLUMN stored_alarm.status
  IS 'open: it goes on; ended; merged: a part of merged_into; withdrawn: data that came later took it back; recalibrated: ended by a new calibration';
COMMENT ON COLUMN stored_alarm.is_proving
  IS '1 if it opened within as many judgements as calibration has blocks: it asks for a decision; else 0';
COMMENT ON COLUMN stored_alarm.told_as
  IS 'proving while it asks for that decision, high while it is open and its indicator opened it, else its status';
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
  IS 'What the rate of false alarms rests on: replay, extrapolated, table, drifting or none; indicator: it has no limit of judgements, and no rate can be stated';
COMMENT ON COLUMN stored_alarm.asked IS 'The false alarms that were asked for';
COMMENT ON COLUMN stored_alarm.stated_rate
  IS 'False alarms that its limit is for, per judgement; NULL where none can be stated';
COMMENT ON COLUMN stored_alarm.signals_open IS 'Signals of its machine that are open now';
COMMENT ON COLUMN stored_alarm.merged_into IS 'The episode that it is a part of; NULL unless merged';
COMMENT ON COLUMN stored_alarm.seq IS 'Number of its newest change';
COMMENT ON COLUMN stored_alarm.version_id IS 'The version whose judgements it is made of';
COMMENT ON COLUMN stored_alarm.channel_id IS 'The channel';
COMMENT ON COLUMN stored_alarm.incident_id
  IS 'Its incident: smallest number of the episodes of its machine that opened within two judgements of one another; NULL if it is merged or withdrawn';
COMMENT ON COLUMN stored_alarm.signals_together IS 'How many these are; 1 if it opened alone';

-- Alarm event: each change of an episode that somebody may want to be told, in order. A notifier remembers the largest seq
-- that it has seen, and sends one message for an incident: the first opening of it, and of each later change the first of
-- those that were noticed together.
CREATE OR REPLACE VIEW stored_alarm_event AS
SELECT
  event.monitor AS monitor,
  event.seq AS seq,
  event.episode_id AS episode_id,
  event.what AS what,
  event.noticed_at AS noticed_at,
  event.asset AS asset,
  event.channel AS channel,
  event.status AS status,
  event.is_proving AS is_proving,
  event.basis AS basis,
  event.incident_id AS incident_id,
  event.signals_together AS signals_together,
  CASE WHEN event.place = 1 THEN 1 ELSE 0 END AS is_message
FROM (
  SELECT
    raised.monitor AS monitor,
    changed.seq AS seq,
    changed.episode_id AS episode_id,
    changed.what AS what,
    MAKE_TIMESTAMP(changed.noticed_at) AS noticed_at,
    raised.asset AS asset,
    raised.channel AS channel,
    changed.status AS status,
    changed.is_proving AS is_proving,
    raised.basis AS basis,
    raised.incident_id AS incident_id,
    raised.signals_together AS signals_together,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY
          raised.monitor,
          CASE WHEN raised.incident_id IS NULL THEN -changed.episode_id ELSE raised.incident_id END,
          changed.what,
          CASE WHEN changed.what = 'opened' THEN 0 ELSE changed.noticed_at END
        ORDER BY changed.seq
      ) AS BIGINT
    ) AS place
  FROM stored_episode AS changed
  JOIN stored_monitor AS watching ON watching.monitor_id = changed.monitor_id
  JOIN stored_alarm AS raised ON raised.monitor = watching.name AND raised.episode_id = changed.episode_id
  WHERE changed.what <> 'changed'
) AS event;

COMMENT ON VIEW stored_alarm_event IS 'Changes of episodes; one row per change, seq only grows within a monitor';
COMMENT ON COLUMN stored_alarm_event.monitor IS 'The monitor';
COMMENT ON COLUMN stored_alarm_event.seq IS 'Number of the change; a later one is larger';
COMMENT ON COLUMN stored_alarm_event.episode_id IS 'The episode';
COMMENT ON COLUMN stored_alarm_event.what IS 'opened, reopened, ended, merged, withdrawn, recalibrated or labelled';
COMMENT ON COLUMN stored_alarm_event.noticed_at IS 'When it was noticed (UTC)';
COMMENT ON COLUMN stored_alarm_event.asset IS 'The machine';
COMMENT ON COLUMN stored_alarm_event.channel IS 'The signal';
COMMENT ON COLUMN stored_alarm_event.status IS 'Of the episode from then on';
COMMENT ON COLUMN stored_alarm_event.is_proving IS '1 if it opened right after calibration, else 0';
COMMENT ON COLUMN stored_alarm_event.basis
  IS 'What its rate of false alarms rests on; indicator: it has no limit of judgements, and no rate can be stated';
COMMENT ON COLUMN stored_alarm_event.incident_id
  IS 'The incident that it is a part of now, as in alarm; NULL if it is merged or withdrawn';
COMMENT ON COLUMN stored_alarm_event.signals_together IS 'How many episodes the incident has; 0 likewise';
COMMENT ON COLUMN stored_alarm_event.is_message
  IS '1 if it is what an incident is told by: its first opening, or the first of other changes noticed together; else 0';

-- Alarm band: in which part of the range an episode stands out: the novel vectors of its first five judgements, less those
-- that as many vectors there held in calibration. A band begins and ends at edges of bins, which calibration saw.
CREATE OR REPLACE VIEW stored_alarm_band AS
SELECT
  watching.name AS monitor,
  episode_band.episode_id AS episode_id,
  named.asset AS asset,
  named.channel AS channel,
  episode_band.version_id AS version_id,
  episode_band.band AS band,
  CASE
    WHEN episode_band.band < 0 THEN 'below'
    WHEN episode_band.band = episode_band.bands THEN 'above'
    ELSE 'within'
  END AS place,
  CASE
    WHEN episode_band.band < 0 THEN NULL
    WHEN episode_band.band = episode_band.bands THEN learnt.calibrated_hi
    ELSE learnt.calibrated_lo
      + (learnt.calibrated_hi - learnt.calibrated_lo)
        * FLOOR(
          (CAST(episode_band.band * episode_band.bins + episode_band.bands AS DOUBLE) - CAST(5e-1 AS DOUBLE))
          / CAST(episode_band.bands AS DOUBLE)
        )
        / CAST(episode_band.bins AS DOUBLE)
  END AS value_from,
  CASE
    WHEN episode_band.band = episode_band.bands THEN NULL
    WHEN episode_band.band < 0 THEN learnt.calibrated_lo
    WHEN episode_band.band = episode_band.bands - 1 THEN learnt.calibrated_hi
    ELSE learnt.calibrated_lo
      + (learnt.calibrated_hi - learnt.calibrated_lo)
        * FLOOR(
          (CAST((episode_band.band + 1) * episode_band.bins + episode_band.bands AS DOUBLE) - CAST(5e-1 AS DOUBLE))
          / CAST(episode_band.bands AS DOUBLE)
        )
        / CAST(episode_band.bins AS DOUBLE)
  END AS value_to,
  episode_band.novel AS novel,
  episode_band.visits AS visits,
  CASE WHEN taught.hit = 1 THEN taught.novel_buffered ELSE 0 END AS calibration_novel,
  CASE WHEN taught.hit = 1 THEN taught.visits ELSE 0 END AS calibration_visits,
  CASE
    WHEN taught.hit = 1
      THEN CAST(episode_band.novel * taught.visits - episode_band.visits * taught.novel_buffered AS DOUBLE)
        / CAST(CASE WHEN taught.visits > 0 THEN taught.visits ELSE 1 END AS DOUBLE)
    ELSE CAST(episode_band.novel AS DOUBLE)
  END AS excess
FROM (
  SELECT
    raised.monitor_id AS monitor_id,
    raised.episode_id AS episode_id,
    raised.channel_id AS channel_id,
    raised.version_id AS version_id,
    version.support_id AS support_id,
    version.bins AS bins,
    CASE WHEN version.bins < 20 THEN version.bins ELSE 20 END AS bands,
    counted.band AS band,
    CAST(SUM(counted.novel) AS BIGINT) AS novel,
    CAST(SUM(counted.visits) AS BIGINT) AS visits
  FROM stored_visible_episode AS raised
  JOIN stored_version AS version ON version.version_id = raised.version_id
  JOIN (
    SELECT
      band_visit.version_id AS version_id,
      band_visit.judgement_no AS judgement_no,
      band_visit.band AS band,
      MAX(band_visit.novel) AS novel,
      MAX(band_visit.visits) AS visits
    FROM stored_band_visit AS band_visit
    JOIN stored_visible_judgement AS judgement
      ON judgement.version_id = band_visit.version_id
      AND judgement.judgement_no = band_visit.judgement_no
      AND judgement.run_id = band_visit.run_id
    WHERE band_visit.visits > 0
    GROUP BY band_visit.version_id, band_visit.judgement_no, band_visit.band
  ) AS counted
    ON counted.version_id = raised.version_id
    AND counted.judgement_no >= raised.first_judgement
    AND counted.judgement_no <= raised.last_judgement
    AND counted.judgement_no < raised.first_judgement + 5
  WHERE raised.status <> 'merged' AND raised.status <> 'withdrawn'
  GROUP BY
    raised.monitor_id,
    raised.episode_id,
    raised.channel_id,
    raised.version_id,
    version.support_id,
    version.bins,
    counted.band
) AS episode_band
JOIN stored_channel AS named ON named.channel_id = episode_band.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = episode_band.monitor_id
JOIN stored_bounds AS learnt ON learnt.support_id = episode_band.support_id
LEFT JOIN (
  SELECT
    part.version_id AS version_id,
    part.band AS band,
    part.visits AS visits,
    part.novel_buffered AS novel_buffered,
    1 AS hit
  FROM stored_band AS part
  JOIN (
    SELECT
      limit_row.version_id AS version_id,
      limit_row.g AS g,
      CAST(ROW_NUMBER() OVER (PARTITION BY limit_row.version_id ORDER BY limit_row.limit_no DESC) AS BIGINT)
        AS limits_back
    FROM stored_limit AS limit_row
    WHERE limit_row.height IS NOT NULL
  ) AS limited ON limited.version_id = part.version_id AND limited.g = part.g
  WHERE limited.limits_back = 1
) AS taught ON taught.version_id = episode_band.version_id AND taught.band = episode_band.band;

COMMENT ON VIEW stored_alarm_band
  IS 'In which part of its range an episode stands out; one row per band that its first five judgements visited';
COMMENT ON COLUMN stored_alarm_band.monitor IS 'The monitor';
COMMENT ON COLUMN stored_alarm_band.episode_id IS 'Number of the episode';
COMMENT ON COLUMN stored_alarm_band.asset IS 'The machine';
COMMENT ON COLUMN stored_alarm_band.channel IS 'The signal';
COMMENT ON COLUMN stored_alarm_band.version_id IS 'The version whose judgements it is made of';
COMMENT ON COLUMN stored_alarm_band.band
  IS '-1 below the range of calibration, 0, 1, ... in it from low to high, 20 (or bins, if they are fewer) above it';
COMMENT ON COLUMN stored_alarm_band.place
  IS 'below or above the range of calibration, or within: from value_from to value_to';
COMMENT ON COLUMN stored_alarm_band.value_from IS 'Lower end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_alarm_band.value_to IS 'Upper end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_alarm_band.novel IS 'Novel vectors of the first five judgements whose newest sample lies there';
COMMENT ON COLUMN stored_alarm_band.visits IS 'All their vectors whose newest sample lies there';
COMMENT ON COLUMN stored_alarm_band.calibration_novel
  IS 'Vectors of calibration there whose cell no block farther away visited';
COMMENT ON COLUMN stored_alarm_band.calibration_visits IS 'All vectors of calibration there';
COMMENT ON COLUMN stored_alarm_band.excess
  IS 'novel less visits * calibration_novel / calibration_visits: the novel vectors that calibration does not explain';

-- Alarm cell: the ten commonest novel cells of each episode of an active version, one interval per axis, each beside the
-- healthy cell of the same program that lies nearest: the one whose largest step on any axis is smallest, of several the
-- one of the smallest key.
CREATE OR REPLACE VIEW stored_alarm_cell AS
SELECT
  ranked.monitor AS monitor,
  ranked.episode_id AS episode_id,
  ranked.asset AS asset,
  ranked.channel AS channel,
  ranked.version_id AS version_id,
  ranked.cell_rank AS cell_rank,
  ranked.cell_key AS cell_key,
  ranked.visits AS visits,
  CASE WHEN ranked.is_dated = 1 THEN MAKE_TIMESTAMP(ranked.first_tick) END AS first_time,
  CASE WHEN ranked.is_dated = 1 THEN MAKE_TIMESTAMP(ranked.last_tick) END AS last_time,
  ranked.first_tick AS first_tick,
  ranked.last_tick AS last_tick,
  ranked.axis AS axis,
  ranked.samples_before AS samples_before,
  ranked.place AS place,
  ranked.value_from AS value_from,
  ranked.value_to AS value_to,
  ranked.nearest_key AS nearest_key,
  ranked.steps AS steps,
  ranked.displacement AS displacement,
  ranked.program AS program
FROM (
  SELECT
    apart.monitor AS monitor,
    apart.episode_id AS episode_id,
    apart.asset AS asset,
    apart.channel AS channel,
    apart.version_id AS version_id,
    apart.cell_rank AS cell_rank,
    apart.cell_key AS cell_key,
    apart.visits AS visits,
    apart.is_dated AS is_dated,
    apart.first_tick AS first_tick,
    apart.last_tick AS last_tick,
    apart.axis AS axis,
    apart.samples_before AS samples_before,
    apart.place AS place,
    apart.value_from AS value_from,
    apart.value_to AS value_to,
    apart.nearest_key AS nearest_key,
    apart.steps AS steps,
    apart.displacement AS displacement,
    apart.program AS program,
    CAST(
      DENSE_RANK() OVER (
        PARTITION BY apart.version_id, apart.episode_id, apart.cell_key ORDER BY apart.steps, apart.nearest_key
      ) AS BIGINT
    ) AS nearness
  FROM (
    SELECT
      fresh.monitor AS monitor,
      fresh.episode_id AS episode_id,
      fresh.asset AS asset,
      fresh.channel AS channel,
      fresh.version_id AS version_id,
      fresh.cell_rank AS cell_rank,
      fresh.cell_key AS cell_key,
      fresh.visits AS visits,
      fresh.is_dated AS is_dated,
      fresh.first_tick AS first_tick,
      fresh.last_tick AS last_tick,
      fresh.axis AS axis,
      fresh.samples_before AS samples_before,
      fresh.place AS place,
      fresh.value_from AS value_from,
      fresh.value_to AS value_to,
      fresh.program AS program,
      healthy.cell_key AS nearest_key,
      fresh.code - healthy.code AS displacement,
      MAX(CASE WHEN fresh.code > healthy.code THEN fresh.code - healthy.code ELSE healthy.code - fresh.code END) OVER (
        PARTITION BY fresh.version_id, fresh.episode_id, fresh.cell_key, healthy.cell_key
      ) AS steps
    FROM (
      SELECT
        coordinate.monitor AS monitor,
        common.episode_id AS episode_id,
        coordinate.asset AS asset,
        coordinate.channel AS channel,
        coordinate.version_id AS version_id,
        common.cell_rank AS cell_rank,
        coordinate.cell_key AS cell_key,
        common.visits AS visits,
        CASE WHEN coordinate.first_time IS NULL THEN 0 ELSE 1 END AS is_dated,
        common.first_tick AS first_tick,
        common.last_tick AS last_tick,
        coordinate.axis AS axis,
        coordinate.samples_before AS samples_before,
        coordinate.place AS place,
        coordinate.value_from AS value_from,
        coordinate.value_to AS value_to,
        coordinate.code AS code,
        coordinate.program_no AS program_no,
        coordinate.program AS program
      FROM stored_cell AS coordinate
      JOIN (
        SELECT
          seen.version_id AS version_id,
          seen.episode_id AS episode_id,
          seen.cell_key AS cell_key,
          seen.visits AS visits,
          seen.first_tick AS first_tick,
          seen.last_tick AS last_tick,
          CAST(
            ROW_NUMBER() OVER (
              PARTITION BY seen.version_id, seen.episode_id ORDER BY seen.visits DESC, seen.cell_key
            ) AS BIGINT
          ) AS cell_rank
        FROM (
          SELECT
            raised.version_id AS version_id,
            raised.episode_id AS episode_id,
            strange.cell_key AS cell_key,
            CAST(SUM(strange.visits) AS BIGINT) AS visits,
            MIN(strange.first_time) AS first_tick,
            MAX(strange.last_time) AS last_tick
          FROM stored_visible_episode AS raised
          JOIN stored_version AS version ON version.version_id = raised.version_id
          JOIN stored_visible_novel AS strange
            ON strange.version_id = raised.version_id
            AND strange.bucket_no * version.stride >= raised.first_judgement * version.window_length
            AND strange.bucket_no * version.stride < (raised.last_judgement + 1) * version.window_length
          WHERE raised.status <> 'merged' AND raised.status <> 'withdrawn'
          GROUP BY raised.version_id, raised.episode_id, strange.cell_key
        ) AS seen
      ) AS common ON common.version_id = coordinate.version_id AND common.cell_key = coordinate.cell_key
      WHERE coordinate.kind = 'novel' AND common.cell_rank <= 10
    ) AS fresh
    JOIN stored_cell AS healthy
      ON healthy.version_id = fresh.version_id AND healthy.axis = fresh.axis AND healthy.program_no = fresh.program_no
    WHERE healthy.kind = 'healthy'
  ) AS apart
) AS ranked
WHERE ranked.nearness = 1;

COMMENT ON VIEW stored_alarm_cell
  IS 'Where an episode went instead: its ten commonest novel cells; one row per cell and axis';
COMMENT ON COLUMN stored_alarm_cell.monitor IS 'The monitor';
COMMENT ON COLUMN stored_alarm_cell.episode_id IS 'Number of the episode';
COMMENT ON COLUMN stored_alarm_cell.asset IS 'The machine';
COMMENT ON COLUMN stored_alarm_cell.channel IS 'The signal';
COMMENT ON COLUMN stored_alarm_cell.version_id IS 'The version whose judgements it is made of; an active one';
COMMENT ON COLUMN stored_alarm_cell.cell_rank IS '1 for the commonest novel cell of the episode, up to 10';
COMMENT ON COLUMN stored_alarm_cell.cell_key IS 'The cell: its codes on the m axes, as one integer';
COMMENT ON COLUMN stored_alarm_cell.visits IS 'Vectors of the episode in it';
COMMENT ON COLUMN stored_alarm_cell.first_time
  IS 'Time of the first of them (UTC); NULL where the source counts time, see first_tick';
COMMENT ON COLUMN stored_alarm_cell.last_time
  IS 'Time of the last of them (UTC); NULL where the source counts time, see last_tick';
COMMENT ON COLUMN stored_alarm_cell.first_tick
  IS 'Time of the first of them: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_alarm_cell.last_tick
  IS 'Time of the last of them: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_alarm_cell.axis IS 'Which coordinate: 0 is the newest sample of the vector';
COMMENT ON COLUMN stored_alarm_cell.samples_before IS 'How many samples before the newest it lies: axis * tau';
COMMENT ON COLUMN stored_alarm_cell.place
  IS 'below or above the range of calibration; within: in the bin from value_from to value_to';
COMMENT ON COLUMN stored_alarm_cell.value_from IS 'Lower end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_alarm_cell.value_to IS 'Upper end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_alarm_cell.nearest_key IS 'The healthy cell that lies nearest';
COMMENT ON COLUMN stored_alarm_cell.steps IS 'How far that is: the largest step on any axis, in bins';
COMMENT ON COLUMN stored_alarm_cell.displacement IS 'By how many bins it lies above that on this axis; less than 0 for below';
COMMENT ON COLUMN stored_alarm_cell.program
  IS 'The program that both are of; NULL where states are of no program';
