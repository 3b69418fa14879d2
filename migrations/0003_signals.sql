-- Health: the indicator at the end of every full bucket, with its limit beside it, which is that of
-- sql/judgement/hi_limit.sql, word for word. Filters reach the stored rows.
CREATE OR REPLACE VIEW stored_health AS
SELECT
  watching.name AS monitor,
  named.asset AS asset,
  named.channel AS channel,
  version.version_no AS version_no,
  full_bucket.bucket_no AS bucket,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(full_bucket.first_time) END
    AS first_time,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(full_bucket.last_time) END
    AS last_time,
  full_bucket.first_time AS first_tick,
  full_bucket.last_time AS last_tick,
  full_bucket.samples AS samples,
  full_bucket.novel AS novel,
  full_bucket.out_of_range AS out_of_range,
  full_bucket.novel_in_window AS novel_in_window,
  version.window_length AS window_length,
  CASE
    WHEN full_bucket.novel_in_window IS NOT NULL
      THEN CAST(full_bucket.novel_in_window AS DOUBLE) / CAST(version.window_length AS DOUBLE)
  END AS hi,
  learnt.verdict AS verdict,
  learnt.taught_by AS taught_by,
  learnt.hi_limit AS hi_limit
FROM stored_visible_bucket AS full_bucket
JOIN stored_version AS version ON version.version_id = full_bucket.version_id
JOIN stored_certified AS learnt ON learnt.version_id = version.version_id
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS active ON active.newest_id = version.version_id
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id;

COMMENT ON VIEW stored_health
  IS 'Health indicator at the end of every full bucket of scored vectors, active versions only';
COMMENT ON COLUMN stored_health.monitor IS 'The monitor';
COMMENT ON COLUMN stored_health.asset IS 'The machine';
COMMENT ON COLUMN stored_health.channel IS 'The signal';
COMMENT ON COLUMN stored_health.version_no IS 'Which calibration of the channel: 1, 2, ...';
COMMENT ON COLUMN stored_health.bucket
  IS 'Number of the bucket: (number of a scored vector - 1) div stride';
COMMENT ON COLUMN stored_health.first_time
  IS 'Time of its first vector (UTC); NULL where the source counts time, see first_tick';
COMMENT ON COLUMN stored_health.last_time
  IS 'Time of its last vector (UTC); NULL where the source counts time, see last_tick';
COMMENT ON COLUMN stored_health.first_tick
  IS 'Time of its first vector: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_health.last_tick
  IS 'Time of its last vector: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_health.samples
  IS 'Samples after the previous bucket up to the end of this one, missing ones included';
COMMENT ON COLUMN stored_health.novel IS 'Vectors in the bucket whose cell is not in the support';
COMMENT ON COLUMN stored_health.out_of_range
  IS 'Vectors in the bucket with a sample outside the range of calibration; all of them are novel';
COMMENT ON COLUMN stored_health.novel_in_window
  IS 'Novel vectors in the window that ends with the bucket; NULL until the window is full';
COMMENT ON COLUMN stored_health.window_length IS 'Scored vectors in a window';
COMMENT ON COLUMN stored_health.hi
  IS 'Health indicator: novel_in_window / window_length, 0 like calibration, 1 all states never seen';
COMMENT ON COLUMN stored_health.verdict
  IS 'Is the calibration good enough? ready, too_fine, needs_data, constant or no_data';
COMMENT ON COLUMN stored_health.taught_by
  IS 'The machines that taught its pool, in words; NULL for a channel that stands alone, or where nobody taught';
COMMENT ON COLUMN stored_health.hi_limit IS 'Where hi is high; NULL where nothing is to be judged';

-- Stillness: the channels whose signal stands still now, at the end of what the newest run that found any row read.
CREATE OR REPLACE VIEW stored_stillness AS
SELECT
  watching.name AS monitor,
  named.asset AS asset,
  named.channel AS channel,
  version.version_id AS version_id,
  version.still_after AS still_after,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(held.still_tick) END AS still_since_time,
  held.still_tick AS still_since_tick
FROM (
  SELECT run.version_id AS version_id, MAX(run.still_since) AS still_tick
  FROM stored_run AS run
  JOIN (
    SELECT version_id, MAX(run_id) AS newest_id
    FROM stored_finished_run
    WHERE settled_bucket IS NOT NULL
    GROUP BY version_id
  ) AS reading ON reading.version_id = run.version_id AND reading.newest_id = run.run_id
  WHERE run.still_since IS NOT NULL
  GROUP BY run.version_id
) AS held
JOIN stored_version AS version ON version.version_id = held.version_id
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS active ON active.newest_id = version.version_id
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id;

COMMENT ON VIEW stored_stillness IS 'The channels whose signal stands still now; a machine that stands, or a frozen reading';
COMMENT ON COLUMN stored_stillness.monitor IS 'The monitor';
COMMENT ON COLUMN stored_stillness.asset IS 'The machine';
COMMENT ON COLUMN stored_stillness.channel IS 'The signal';
COMMENT ON COLUMN stored_stillness.version_id IS 'Its active version';
COMMENT ON COLUMN stored_stillness.still_after
  IS 'Equal samples in a row from which on the signal stands still and counts as missing';
COMMENT ON COLUMN stored_stillness.still_since_time
  IS 'Since when it stands still (UTC), as far as it is scored; NULL where the source counts time';
COMMENT ON COLUMN stored_stillness.still_since_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';

-- Onset: since when the indicator of each version is above its limit without a break, over the buckets that are
-- kept, and how long its buckets take. The limit is that of sql/judgement/hi_limit.sql, word for word.
CREATE OR REPLACE VIEW stored_onset AS
SELECT
  history.version_id AS version_id,
  CAST(COUNT(*) AS BIGINT) AS buckets,
  MIN(history.first_time) AS first_tick,
  MAX(history.last_time) AS last_tick,
  MAX(history.since_bucket) AS since_bucket,
  MAX(CASE WHEN history.bucket_no = history.since_bucket THEN history.last_time END) AS since_tick,
  MIN(
    CASE WHEN history.bucket_no > history.since_bucket - history.in_window THEN history.first_time END
  ) AS window_from_tick,
  MAX(
    CASE
      WHEN history.bucket_no = history.since_bucket AND history.since_bucket > history.last_below + 1 THEN 1
      WHEN history.bucket_no = history.since_bucket THEN 0
    END
  ) AS at_least
FROM (
  SELECT
    version_id,
    bucket_no,
    first_time,
    last_time,
    in_window,
    last_below,
    MIN(CASE WHEN bucket_no > last_below THEN bucket_no END) OVER (PARTITION BY version_id)
      AS since_bucket
  FROM (
    SELECT
      version_id,
      bucket_no,
      first_time,
      last_time,
      in_window,
      MAX(CASE WHEN is_above = 1 THEN -1 ELSE bucket_no END) OVER (PARTITION BY version_id) AS last_below
    FROM (
      SELECT
        full_bucket.version_id AS version_id,
        full_bucket.bucket_no AS bucket_no,
        full_bucket.first_time AS first_time,
        full_bucket.last_time AS last_time,
        CAST(version.window_length AS DOUBLE) / CAST(version.stride AS DOUBLE) AS in_window,
        CASE
          WHEN full_bucket.novel_in_window IS NULL OR version.hi_limit IS NULL THEN 0
          WHEN CAST(full_bucket.novel_in_window AS DOUBLE) / CAST(version.window_length AS DOUBLE)
            > version.hi_limit THEN 1
          ELSE 0
        END AS is_above
      FROM stored_visible_bucket AS full_bucket
      JOIN (
        SELECT
          version.version_id AS version_id,
          version.window_length AS window_length,
          version.stride AS stride,
          learnt.hi_limit AS hi_limit
        FROM stored_version AS version
        JOIN stored_certified AS learnt ON learnt.version_id = version.version_id
      ) AS version ON version.version_id = full_bucket.version_id
    ) AS compared
  ) AS bounded
) AS history
GROUP BY history.version_id;

COMMENT ON VIEW stored_onset
  IS 'Since when each version is above its limit, over the buckets that are kept; one row per version';
COMMENT ON COLUMN stored_onset.version_id IS 'The version';
COMMENT ON COLUMN stored_onset.buckets IS 'Buckets that are kept';
COMMENT ON COLUMN stored_onset.first_tick IS 'Time of the first vector of the oldest of them';
COMMENT ON COLUMN stored_onset.last_tick IS 'Time of the last vector of the newest of them';
COMMENT ON COLUMN stored_onset.since_bucket
  IS 'First bucket of the unbroken run above the limit that lasts to the newest; NULL if that is not above';
COMMENT ON COLUMN stored_onset.since_tick IS 'Time of the last vector of that bucket';
COMMENT ON COLUMN stored_onset.window_from_tick
  IS 'Time of the first vector of the window that ends with it, as far as its buckets are kept';
COMMENT ON COLUMN stored_onset.at_least
  IS '1 if the bucket before is no longer kept, so that the run may be longer; else 0; NULL if not above';

-- Fleet: what is known of every channel now, one row each, under its active version. A channel that would
-- be ok or waiting and stands still is standing: neither healthy nor alarming. Its episode says whether it is above, and
-- since when: since the onset of that. judged_by says what opens one: its judgements, where calibration gave them a
-- limit, else its indicator by hi_limit. limit, reason, urgency, attention and the status of what moves are those of
-- sql/judgement/, word for word. A run whose context differs has read another number of samples before its first bucket
-- than were there when that bucket was scored: rows came later than lookback allows, or went. A later run that began to
-- read no later speaks in its place; one that found no row at all says nothing. Only runs that tell something are put
-- in order: the newest of a version, the newest that read anything, which says what its newest data is, the newest that
-- counted its calibration, and all where a context differs.
CREATE OR REPLACE VIEW stored_fleet AS
SELECT
  watching.name AS monitor,
  named.asset AS asset,
  named.channel AS channel,
  version.version_no AS version_no,
  version.version_id AS version_id,
  learnt.verdict AS verdict,
  learnt.floor AS floor,
  learnt.floor_sd AS floor_sd,
  learnt.floor_max AS floor_max,
  judged.hi_limit AS hi_limit,
  judged.hi AS hi,
  judged.hi_highest AS hi_highest,
  judged.novel_in_window AS novel_in_window,
  judged.novel_window_before AS novel_window_before,
  judged.out_of_range_in_window AS out_of_range_in_window,
  version.window_length AS window_length,
  version.stride AS stride,
  judged.bucket AS bucket,
  judged.buckets AS buckets,
  judged.novel_in_buckets AS novel_in_buckets,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(judged.last_tick) END AS last_time,
  judged.last_tick AS last_tick,
  CASE
    WHEN looked.hit = 1 AND watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(looked.read_to)
  END AS data_time,
  CASE WHEN looked.hit = 1 THEN looked.read_to END AS data_tick,
  CASE WHEN looked.hit = 1 THEN MAKE_TIMESTAMP(looked.committed) END AS looked_at,
  CASE WHEN looked.hit = 1 THEN looked.differing ELSE 0 END AS differing_contexts,
  CASE
    WHEN looked.hit = 1 AND watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(looked.repair_from)
  END AS repair_from_time,
  CASE WHEN looked.hit = 1 THEN looked.repair_from END AS repair_from_tick,
  version.calibration_readings AS calibration_readings,
  CASE WHEN looked.hit = 1 THEN looked.calibration_readings END AS calibration_readings_now,
  learnt.calibration_vectors AS calibration_vectors,
  learnt.cells AS cells,
  learnt.calibrated_lo AS calibrated_lo,
  learnt.calibrated_hi AS calibrated_hi,
  learnt.finest_bins AS finest_bins,
  learnt.vectors_needed AS vectors_needed,
  learnt.sees AS sees,
  learnt.sees_half_stroke AS sees_half_stroke,
  learnt.sees_frozen AS sees_frozen,
  learnt.sees_faster AS sees_faster,
  learnt.sees_slower AS sees_slower,
  learnt.would_not_see AS would_not_see,
  learnt.blind_reason AS blind_reason,
  learnt.vouched_by AS vouched_by,
  learnt.taught_by AS taught_by,
  learnt.member_floor AS member_floor,
  CASE
    WHEN learnt.vouched_by = 1 THEN 'not vouched: only ' || learnt.taught_by || ' taught'
    WHEN learnt.vouched_by > 1 THEN 'judged by ' || learnt.taught_by || '; of itself nothing is known'
  END AS vouching,
  version.m AS m,
  version.tau AS tau,
  version.bins AS bins,
  version.target_floor AS target_floor,
  version.settings_hash AS settings_hash,
  version.method_hash AS method_hash,
  CASE WHEN judged.has_limit = 0 THEN 'unrepresentative' ELSE judged.limit_reason END AS limit_reason,
  CASE WHEN still.hit = 1 AND judged.status IN ('ok', 'waiting', 'blind') THEN 'standing' ELSE judged.status END AS status,
  judged.urgency AS urgency,
  judged.needs_attention AS needs_attention,
  CASE WHEN still.hit = 1 AND judged.status = 'ok' THEN NULL ELSE judged.is_above END AS is_above,
  judged.judged_by AS judged_by,
  judged.episode_id AS episode_id,
  judged.asking AS asking,
  judged.label AS label,
  judged.is_far_above AS is_far_above,
  judged.strength AS strength,
  CASE
    WHEN watching.time_kind = 'counter' THEN NULL
    WHEN judged.is_above = 1 AND judged.raised IS NOT NULL THEN MAKE_TIMESTAMP(judged.raised_tick)
    WHEN judged.is_above = 1 AND rising.hit = 1 THEN MAKE_TIMESTAMP(rising.since_tick)
  END AS since_time,
  CASE
    WHEN judged.is_above = 1 AND judged.raised IS NOT NULL THEN judged.raised_tick
    WHEN judged.is_above = 1 AND rising.hit = 1 THEN rising.since_tick
  END AS since_tick,
  CASE
    WHEN judged.is_above = 1 AND judged.raised IS NOT NULL THEN judged.window_before_tick
    WHEN judged.is_above = 1 AND rising.hit = 1 THEN rising.window_from_tick
  END AS window_from_tick,
  CASE
    WHEN judged.is_above = 1 AND judged.raised IS NOT NULL THEN 0
    WHEN judged.is_above = 1 AND rising.hit = 1 THEN rising.at_least
  END AS at_least,
  CASE
    WHEN looked.hit = 1 AND rising.hit = 1 AND heard.hit = 1 AND heard.newest_tick > looked.read_to
      AND CAST(heard.newest_tick - looked.read_to AS DOUBLE) * CAST(rising.buckets AS DOUBLE)
        > CAST(3 AS DOUBLE) * CAST(rising.last_tick - rising.first_tick AS DOUBLE)
      THEN heard.newest_tick - looked.read_to
  END AS silent_for
FROM stored_version AS version
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS active ON active.newest_id = version.version_id
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id
JOIN stored_certified AS learnt ON learnt.version_id = version.version_id
JOIN (
  SELECT
    status,
    CASE
      WHEN asks = 1 AND status = 'proving' THEN 6
      WHEN status = 'high' AND asks = 0 AND has_limit IS NOT NULL THEN 2
      WHEN status = 'high' THEN 4
      WHEN asks = 1 THEN 5
      WHEN status = 'setup' THEN 3
      WHEN status IN ('proving', 'open', 'waiting', 'blind') THEN 2
      WHEN status = 'ok' THEN 1
      ELSE 0
    END AS urgency,
    CASE
      WHEN status = 'high' AND asks = 0 AND has_limit IS NOT NULL THEN 0
      WHEN asks = 1 OR status IN ('high', 'setup') THEN 1
      ELSE 0
    END AS needs_attention,
    CASE WHEN status IN ('proving', 'open', 'high') THEN 1 WHEN status IN ('ok', 'labelled') THEN 0 END AS is_above,
    CASE WHEN judged_by IS NOT NULL AND hi >= 10 * hi_limit THEN 1 ELSE 0 END AS is_far_above,
    CASE
      WHEN status IN ('proving', 'open') THEN sure
      WHEN status = 'high' AND hi_limit > 0 THEN hi / hi_limit
    END AS strength,
    judged_by,
    version_id,
    verdict,
    hi_limit,
    limit_reason,
    hi,
    hi_highest,
    novel_in_window,
    novel_window_before,
    out_of_range_in_window,
    bucket,
    buckets,
    novel_in_buckets,
    last_tick,
    has_limit,
    raised,
    label,
    sure,
    asks,
    asking,
    episode_id,
    raised_tick,
    window_before_tick
  FROM (
    SELECT
      CASE
        WHEN verdict IN ('no_data', 'constant') THEN 'not assessed'
        WHEN judged_by IS NULL THEN 'setup'
        WHEN raised IS NOT NULL AND label IN ('false_alarm', 'new_program') THEN 'labelled'
        WHEN raised IS NOT NULL THEN raised
        WHEN hi IS NULL THEN 'waiting'
        WHEN judged_by = 'indicator' AND has_limit IS NULL AND hi > hi_limit THEN 'high'
        WHEN verdict = 'blind' THEN 'blind'
        ELSE 'ok'
      END AS status,
      judged_by,
      version_id,
      verdict,
      hi_limit,
      limit_reason,
      hi,
      hi_highest,
      novel_in_window,
      novel_window_before,
      out_of_range_in_window,
      bucket,
      buckets,
      novel_in_buckets,
      last_tick,
      has_limit,
      raised,
      label,
      sure,
      asks,
      asking,
      episode_id,
      raised_tick,
      window_before_tick
    FROM (
      SELECT
        CASE
          WHEN verdict <> 'ready' AND verdict <> 'blind' OR has_limit = 0 THEN NULL
          WHEN has_limit = 1 THEN 'episode'
          ELSE 'indicator'
        END AS judged_by,
        version_id,
        verdict,
        hi_limit,
        limit_reason,
        hi,
        hi_highest,
        novel_in_window,
        novel_window_before,
        out_of_range_in_window,
        bucket,
        buckets,
        novel_in_buckets,
        last_tick,
        has_limit,
        raised,
        label,
        sure,
        asks,
        asking,
        episode_id,
        raised_tick,
        window_before_tick
      FROM (
        SELECT
          version.version_id AS version_id,
          learnt.verdict AS verdict,
          learnt.hi_limit AS hi_limit,
          CASE
            WHEN learnt.verdict = 'no_data' THEN 'no calibration'
            WHEN learnt.verdict = 'constant' THEN 'constant in calibration'
            WHEN learnt.verdict = 'too_fine' THEN 'grid too fine for its calibration'
            WHEN learnt.verdict = 'needs_data' THEN 'calibration too short'
            WHEN learnt.verdict = 'not_vouched' THEN 'only one machine of its pool taught'
          END AS limit_reason,
          CASE
            WHEN shown.hit = 1 AND shown.novel_in_window IS NOT NULL
              THEN CAST(shown.novel_in_window AS DOUBLE) / CAST(version.window_length AS DOUBLE)
          END AS hi,
          CASE
            WHEN shown.hit = 1 AND shown.most_in_window IS NOT NULL
              THEN CAST(shown.most_in_window AS DOUBLE) / CAST(version.window_length AS DOUBLE)
          END AS hi_highest,
          CASE WHEN shown.hit = 1 THEN shown.novel_in_window END AS novel_in_window,
          CASE WHEN shown.hit = 1 THEN shown.novel_window_before END AS novel_window_before,
          CASE WHEN shown.hit = 1 THEN shown.out_of_range END AS out_of_range_in_window,
          CASE WHEN shown.hit = 1 THEN shown.newest_no END AS bucket,
          CASE WHEN shown.hit = 1 THEN shown.buckets ELSE 0 END AS buckets,
          CASE WHEN shown.hit = 1 THEN shown.novel ELSE 0 END AS novel_in_buckets,
          CASE WHEN shown.hit = 1 THEN shown.last_time END AS last_tick,
          CASE
            WHEN limited.hit = 1 AND limited.reason IS NULL THEN 1
            WHEN limited.hit = 1 AND limited.reason = 'unrepresentative' THEN 0
            WHEN limited.hit = 1 THEN -1
          END AS has_limit,
          CASE WHEN raised.hit = 1 THEN raised.told_as END AS raised,
          CASE WHEN raised.hit = 1 THEN raised.label END AS label,
          CASE WHEN raised.hit = 1 THEN CAST(raised.evidence AS DOUBLE) / CAST(raised.height AS DOUBLE) END AS sure,
          CASE WHEN raised.hit = 1 AND raised.asking > 0 THEN 1 ELSE 0 END AS asks,
          CASE WHEN raised.hit = 1 THEN raised.asking ELSE 0 END AS asking,
          CASE WHEN raised.hit = 1 THEN raised.episode_id END AS episode_id,
          CASE WHEN raised.hit = 1 THEN raised.onset_time END AS raised_tick,
          CASE WHEN raised.hit = 1 THEN raised.onset_time - raised.judgement_length END AS window_before_tick
        FROM stored_version AS version
        JOIN stored_certified AS learnt ON learnt.version_id = version.version_id
        LEFT JOIN (
          SELECT limit_row.version_id AS version_id, limit_row.reason AS reason, 1 AS hit
          FROM stored_limit AS limit_row
          JOIN (
            SELECT version_id, MAX(each_limit.limit_no) AS newest_no
            FROM stored_limit AS each_limit
            GROUP BY version_id
          ) AS latest ON latest.version_id = limit_row.version_id AND latest.newest_no = limit_row.limit_no
        ) AS limited ON limited.version_id = version.version_id
        LEFT JOIN (
          SELECT
            going.channel_id AS channel_id,
            going.episode_id AS episode_id,
            going.told_as AS told_as,
            going.label AS label,
            going.evidence AS evidence,
            going.height AS height,
            going.onset_time AS onset_time,
            CAST(
              FLOOR(
                CAST(going.last_time - going.first_time AS DOUBLE) * CAST(2 * version.window_length AS DOUBLE)
                / CAST(
                  2 * (going.last_judgement - going.first_judgement + 1) * version.window_length
                  - CASE WHEN version.window_length > 1 THEN 2 ELSE 0 END AS DOUBLE
                )
              ) AS BIGINT
            ) AS judgement_length,
            CAST(SUM(going.needs_attention) OVER (PARTITION BY going.channel_id) AS BIGINT) AS asking,
            CAST(
              ROW_NUMBER() OVER (
                PARTITION BY going.channel_id
                ORDER BY
                  CASE
                    WHEN going.label IN ('false_alarm', 'new_program') THEN 2
                    WHEN going.status = 'open' THEN 0
                    ELSE 1
                  END,
                  going.episode_id DESC
              ) AS BIGINT
            ) AS episodes_back,
            1 AS hit
          FROM stored_labelled_episode AS going
          JOIN stored_version AS version ON version.version_id = going.version_id
          WHERE going.status = 'open' OR going.needs_attention = 1
        ) AS raised ON raised.channel_id = version.channel_id AND raised.episodes_back = 1
        LEFT JOIN (
          SELECT
            version_id,
            1 AS hit,
            newest_no,
            CAST(COUNT(*) AS BIGINT) AS buckets,
            MAX(history.last_time) AS last_time,
            CAST(SUM(history.novel) AS BIGINT) AS novel,
            CAST(SUM(CASE WHEN vectors_back < window_length THEN history.out_of_range ELSE 0 END) AS BIGINT)
              AS out_of_range,
            MAX(CASE WHEN vectors_back = 0 THEN history.novel_in_window END) AS novel_in_window,
            MAX(CASE WHEN vectors_back = window_length THEN history.novel_in_window END)
              AS novel_window_before,
            MAX(history.novel_in_window) AS most_in_window
          FROM (
            SELECT
              full_bucket.version_id AS version_id,
              newest.newest_no AS newest_no,
              newest.window_length AS window_length,
              (newest.newest_no - full_bucket.bucket_no) * newest.stride AS vectors_back,
              full_bucket.last_time AS last_time,
              full_bucket.novel AS novel,
              full_bucket.out_of_range AS out_of_range,
              full_bucket.novel_in_window AS novel_in_window
            FROM stored_visible_bucket AS full_bucket
            JOIN (
              SELECT
                version.version_id AS version_id,
                version.window_length AS window_length,
                version.stride AS stride,
                counted.newest_no AS newest_no
              FROM stored_version AS version
              JOIN (
                SELECT version_id, MAX(bucket_no) AS newest_no
                FROM stored_visible_bucket
                GROUP BY version_id
              ) AS counted ON counted.version_id = version.version_id
            ) AS newest ON newest.version_id = full_bucket.version_id
          ) AS history
          GROUP BY version_id, newest_no
        ) AS shown ON shown.version_id = version.version_id
      ) AS assessed
    ) AS weighed
  ) AS judged_status
) AS judged ON judged.version_id = version.version_id
LEFT JOIN (
  SELECT
    version_id,
    1 AS hit,
    MAX(CASE WHEN run_id = reading_id THEN run.read_to END) AS read_to,
    MAX(CASE WHEN run_id = newest_id THEN run.committed END) AS committed,
    CAST(SUM(differs) AS BIGINT) AS differing,
    MIN(CASE WHEN differs = 1 THEN read_from END) AS repair_from,
    MAX(CASE WHEN run_id = counted_id THEN run.calibration_readings END) AS calibration_readings
  FROM (
    SELECT
      version_id,
      run_id,
      counted_id,
      newest_id,
      reading_id,
      read_from,
      read_to,
      committed,
      calibration_readings,
      CASE
        WHEN read_to IS NOT NULL
          AND context_rows <> context_expected
          AND (runs_back = 1 OR read_from < read_since)
          THEN 1
        ELSE 0
      END AS differs
    FROM (
      SELECT
        version_id,
        run_id,
        read_from,
        read_to,
        context_rows,
        context_expected,
        committed,
        calibration_readings,
        CAST(ROW_NUMBER() OVER (PARTITION BY version_id ORDER BY run_id DESC) AS BIGINT) AS runs_back,
        MIN(CASE WHEN read_to IS NOT NULL THEN read_from ELSE 4611686018427387904 END) OVER (
          PARTITION BY version_id ORDER BY run_id DESC ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING
        ) AS read_since,
        counted_id,
        newest_id,
        reading_id
      FROM (
        SELECT
          done.version_id AS version_id,
          done.run_id AS run_id,
          done.read_from AS read_from,
          done.read_to AS read_to,
          done.context_rows AS context_rows,
          done.context_expected AS context_expected,
          done.committed AS committed,
          done.calibration_readings AS calibration_readings,
          every_run.counted_id AS counted_id,
          every_run.newest_id AS newest_id,
          every_run.reading_id AS reading_id
        FROM stored_finished_run AS done
        JOIN (
          SELECT
            version_id,
            MAX(run_record.run_id) AS newest_id,
            MAX(CASE WHEN run_record.calibration_readings IS NOT NULL THEN run_record.run_id END) AS counted_id,
            MAX(CASE WHEN run_record.read_to IS NOT NULL THEN run_record.run_id END) AS reading_id,
            MAX(
              CASE
                WHEN run_record.read_to IS NOT NULL AND run_record.context_rows <> run_record.context_expected THEN 1
                ELSE 0
              END
            ) AS has_differing
          FROM stored_finished_run AS run_record
          GROUP BY version_id
        ) AS every_run ON every_run.version_id = done.version_id
        WHERE every_run.has_differing = 1
          OR done.run_id = every_run.newest_id
          OR done.run_id = every_run.reading_id
          OR done.run_id = every_run.counted_id
      ) AS telling
    ) AS finished
  ) AS run
  GROUP BY version_id
) AS looked ON looked.version_id = version.version_id
LEFT JOIN (
  SELECT version_id, buckets, first_tick, last_tick, since_tick, window_from_tick, at_least, 1 AS hit
  FROM stored_onset
) AS rising ON rising.version_id = version.version_id
LEFT JOIN (
  SELECT reader.monitor_id AS monitor_id, MAX(done.read_to) AS newest_tick, 1 AS hit
  FROM stored_finished_run AS done
  JOIN (
    SELECT version_id, MAX(reading.run_id) AS newest_id
    FROM stored_finished_run AS reading
    WHERE reading.read_to IS NOT NULL
    GROUP BY version_id
  ) AS latest ON latest.version_id = done.version_id AND latest.newest_id = done.run_id
  JOIN stored_version AS version ON version.version_id = done.version_id
  JOIN stored_channel AS reader ON reader.channel_id = version.channel_id
  GROUP BY reader.monitor_id
) AS heard ON heard.monitor_id = named.monitor_id
LEFT JOIN (
  SELECT version_id, 1 AS hit
  FROM stored_stillness
) AS still ON still.version_id = version.version_id;

COMMENT ON VIEW stored_fleet IS 'What is known of every channel now, under its active version';
COMMENT ON COLUMN stored_fleet.monitor IS 'The monitor';
COMMENT ON COLUMN stored_fleet.asset IS 'The machine';
COMMENT ON COLUMN stored_fleet.channel IS 'The signal';
COMMENT ON COLUMN stored_fleet.version_no IS 'Which calibration of the channel: 1, 2, ...';
COMMENT ON COLUMN stored_fleet.version_id IS 'Its key in the other tables';
COMMENT ON COLUMN stored_fleet.verdict
  IS 'Is the calibration good enough? ready, too_fine, needs_data, constant or no_data';
COMMENT ON COLUMN stored_fleet.floor
  IS 'Health indicator that a healthy machine would show, from calibration itself';
COMMENT ON COLUMN stored_fleet.floor_sd IS 'Its standard deviation over the blocks of calibration';
COMMENT ON COLUMN stored_fleet.floor_max IS 'The highest block of calibration';
COMMENT ON COLUMN stored_fleet.hi_limit
  IS 'The limit of hi: the largest of 2 * floor, floor_max and target_floor; NULL where the verdict is not ready';
COMMENT ON COLUMN stored_fleet.hi
  IS 'Health indicator now: novel_in_window / window_length; NULL until a window is scored';
COMMENT ON COLUMN stored_fleet.hi_highest IS 'The highest of the buckets that are kept';
COMMENT ON COLUMN stored_fleet.novel_in_window IS 'Novel vectors in the last window';
COMMENT ON COLUMN stored_fleet.novel_window_before
  IS 'Novel vectors in the window before the last; NULL until two windows are scored';
COMMENT ON COLUMN stored_fleet.out_of_range_in_window
  IS 'Vectors of the last window with a sample outside the range of calibration';
COMMENT ON COLUMN stored_fleet.window_length IS 'Scored vectors in a window';
COMMENT ON COLUMN stored_fleet.stride IS 'Scored vectors in a bucket';
COMMENT ON COLUMN stored_fleet.bucket IS 'Number of the last full bucket; NULL before there is one';
COMMENT ON COLUMN stored_fleet.buckets IS 'Buckets that are kept';
COMMENT ON COLUMN stored_fleet.novel_in_buckets IS 'Novel vectors in the buckets that are kept';
COMMENT ON COLUMN stored_fleet.last_time
  IS 'Time of the last scored vector in a full bucket (UTC); NULL where the source counts time';
COMMENT ON COLUMN stored_fleet.last_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
COMMENT ON COLUMN stored_fleet.data_time
  IS 'Newest time read of the channel (UTC); NULL where the source counts time';
COMMENT ON COLUMN stored_fleet.data_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
COMMENT ON COLUMN stored_fleet.looked_at
  IS 'When a run last looked for data of the channel (UTC); NULL if none did';
COMMENT ON COLUMN stored_fleet.differing_contexts
  IS 'Runs that found other samples than were scored: rows came too late, or went; 0 is right';
COMMENT ON COLUMN stored_fleet.repair_from_time
  IS 'Score again from here to mend that (UTC); NULL where the source counts time, or all is well';
COMMENT ON COLUMN stored_fleet.repair_from_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
COMMENT ON COLUMN stored_fleet.calibration_readings IS 'Different readings inside calibration when it was learnt';
COMMENT ON COLUMN stored_fleet.calibration_readings_now
  IS 'The same when it was last counted again; NULL if it never was';
COMMENT ON COLUMN stored_fleet.calibration_vectors IS 'Vectors that were learnt from';
COMMENT ON COLUMN stored_fleet.cells IS 'Cells that they visited: the size of the support';
COMMENT ON COLUMN stored_fleet.calibrated_lo
  IS 'Lowest value in calibration; NULL if it holds no usable sample';
COMMENT ON COLUMN stored_fleet.calibrated_hi IS 'Highest value in calibration';
COMMENT ON COLUMN stored_fleet.finest_bins
  IS 'Finest grid that the calibration is enough for; NULL if none of the ladder is';
COMMENT ON COLUMN stored_fleet.vectors_needed
  IS 'About how many more vectors calibration needs; NULL if that cannot be told';
COMMENT ON COLUMN stored_fleet.sees
  IS 'Smallest shift that its indicator would show both ways, in percent of the usual width, if the machine works as in calibration; NULL if none of 1 to 50 %';
COMMENT ON COLUMN stored_fleet.sees_half_stroke
  IS '1 if its indicator would show a stroke half as long, 0 if not; NULL if that could not be tried';
COMMENT ON COLUMN stored_fleet.sees_frozen IS 'The same of a sensor that gives one value only';
COMMENT ON COLUMN stored_fleet.sees_faster IS 'The same of a machine 1.5 times as fast';
COMMENT ON COLUMN stored_fleet.sees_slower IS 'The same of a machine at two thirds of its speed';
COMMENT ON COLUMN stored_fleet.would_not_see
  IS 'What of a frozen sensor, half a stroke and another speed its indicator would not show, in words; NULL if nothing is known not to';
COMMENT ON COLUMN stored_fleet.blind_reason
  IS 'Why no shift would be seen: range, blocks, cells or delay (docs/sight.md); NULL where the verdict is not blind';
COMMENT ON COLUMN stored_fleet.vouched_by
  IS 'Machines of its pool that vouch for it, where it taught nothing; NULL else';
COMMENT ON COLUMN stored_fleet.taught_by
  IS 'The machines that taught its pool, in words; NULL for a channel that stands alone, or where nobody taught';
COMMENT ON COLUMN stored_fleet.member_floor
  IS 'Health indicator to expect of a whole machine of its pool, by leaving out one that taught after another; NULL where less than two taught';
COMMENT ON COLUMN stored_fleet.vouching
  IS 'By whom it is judged, in words, where it taught its pool nothing; NULL else';
COMMENT ON COLUMN stored_fleet.m IS 'Embedding dimension';
COMMENT ON COLUMN stored_fleet.tau IS 'Delay, in samples';
COMMENT ON COLUMN stored_fleet.bins IS 'Bins per axis';
COMMENT ON COLUMN stored_fleet.target_floor IS 'Health indicator that a healthy machine may show';
COMMENT ON COLUMN stored_fleet.settings_hash IS 'Hash of the settings it was learnt under';
COMMENT ON COLUMN stored_fleet.method_hash IS 'Hash of the SQL that learnt it';
COMMENT ON COLUMN stored_fleet.limit_reason
  IS 'Why nothing judges it, in words: calibration is none, constant, too short, too short for its grid or unrepresentative';
COMMENT ON COLUMN stored_fleet.status
  IS 'proving, open: its episode; high: an episode that its indicator opened; labelled: its episode is a false alarm or a new program; setup: calibration not good enough; waiting: no full window yet; blind: below its limit, but it would not show a shift; standing; ok; not assessed';
COMMENT ON COLUMN stored_fleet.urgency
  IS 'The larger, the sooner to be looked at: 6 proving, 5 open, 4 high, 3 setup, 2 waiting, blind or an episode put aside, 1 ok, 0 labelled or not assessed';
COMMENT ON COLUMN stored_fleet.needs_attention
  IS '1 if somebody should look at it (setup, or an episode that is not put aside), else 0';
COMMENT ON COLUMN stored_fleet.is_above
  IS '1 if it is above its limit (proving, open, high), 0 if not (ok, labelled); NULL where nothing can be judged, or nothing would be seen';
COMMENT ON COLUMN stored_fleet.judged_by
  IS 'episode: its calibration gave a limit of judgements; indicator: only hi_limit; NULL: nothing does';
COMMENT ON COLUMN stored_fleet.episode_id IS 'Its episode: the open one, else the newest that asks; NULL if there is none';
COMMENT ON COLUMN stored_fleet.asking IS 'Episodes of it that need attention';
COMMENT ON COLUMN stored_fleet.label IS 'What people said last of that episode; NULL if nothing';
COMMENT ON COLUMN stored_fleet.is_far_above
  IS '1 if hi is at ten times hi_limit or more, whatever the status; else 0';
COMMENT ON COLUMN stored_fleet.strength
  IS 'Of what is above: the highest evidence of its episode over the height, or hi / hi_limit where the indicator judges it; NULL if it is not';
COMMENT ON COLUMN stored_fleet.since_time
  IS 'Of what is above: onset of its episode (UTC); NULL if it is not, or where the source counts time';
COMMENT ON COLUMN stored_fleet.since_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
COMMENT ON COLUMN stored_fleet.window_from_tick IS 'Where the window begins that ends with it; NULL if it is not above';
COMMENT ON COLUMN stored_fleet.at_least
  IS '1 if older buckets were pruned and no episode says it, so that it may be longer; else 0; NULL if it is not above';
COMMENT ON COLUMN stored_fleet.silent_for
  IS 'How far its newest data is behind the newest of the monitor, where three of its buckets take less; else NULL';

-- Machine: what is known of every machine now, one row each, counted over its signals in fleet, as
-- sql/judgement/machines.sql says, by monitor. Together counts the signals whose onset lies within the window that ended
-- at the onset of one of them: those that began by then, less those that began before that window. Each signal is there
-- three times for it: where its window begins, as one that began, and where it counts.
CREATE OR REPLACE VIEW stored_machine AS
SELECT
  ranked.monitor AS monitor,
  ranked.asset AS asset,
  ranked.signals AS signals,
  ranked.watched AS watched,
  ranked.not_watched AS not_watched,
  beside.judged AS judged,
  ranked.above AS above,
  beside.not_judged AS not_judged,
  beside.since_time AS since_time,
  ranked.since_tick AS since_tick,
  ranked.first_channel AS first_channel,
  ranked.strongest_channel AS strongest_channel,
  ranked.strength AS strength,
  ranked.urgency AS urgency,
  ranked.machine_rank AS machine_rank,
  beside.together AS together,
  beside.data_time AS data_time,
  beside.data_tick AS data_tick
FROM (
  SELECT
    monitor,
    asset,
    signals,
    watched,
    not_watched,
    above,
    since_tick,
    first_channel,
    strongest_channel,
    strength,
    urgency,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY monitor
        ORDER BY urgency DESC, above DESC, CASE WHEN strength IS NULL THEN 1 ELSE 0 END, strength DESC, asset
      ) AS BIGINT
    ) AS machine_rank
  FROM (
    SELECT
      member.monitor AS monitor,
      member.asset AS asset,
      CAST(COUNT(*) AS BIGINT) AS signals,
      CAST(SUM(CASE WHEN member.judged_by IS NULL THEN 0 ELSE 1 END) AS BIGINT) AS watched,
      CAST(SUM(CASE WHEN member.judged_by IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS not_watched,
      CAST(SUM(member.raised) AS BIGINT) AS above,
      MIN(CASE WHEN member.raised = 1 THEN member.since_tick END) AS since_tick,
      MIN(CASE WHEN member.raised = 1 AND member.place = 1 THEN member.channel END) AS first_channel,
      MIN(CASE WHEN member.raised = 1 AND member.strong_place = 1 THEN member.channel END) AS strongest_channel,
      MAX(CASE WHEN member.raised = 1 THEN member.strength END) AS strength,
      MAX(member.urgency) AS urgency
    FROM (
      SELECT
        monitor,
        asset,
        channel,
        judged_by,
        raised,
        since_tick,
        strength,
        urgency,
        CAST(
          ROW_NUMBER() OVER (
            PARTITION BY monitor, asset
            ORDER BY raised DESC, CASE WHEN since_tick IS NULL THEN 1 ELSE 0 END, since_tick, channel
          ) AS BIGINT
        ) AS place,
        CAST(
          ROW_NUMBER() OVER (
            PARTITION BY monitor, asset
            ORDER BY raised DESC, CASE WHEN strength IS NULL THEN 1 ELSE 0 END, strength DESC, channel
          ) AS BIGINT
        ) AS strong_place
      FROM (
        SELECT
          monitor,
          asset,
          channel,
          judged_by,
          CASE WHEN is_above = 1 THEN 1 ELSE 0 END AS raised,
          since_tick,
          strength,
          urgency
        FROM stored_fleet
      ) AS signal_state
    ) AS member
    GROUP BY member.monitor, member.asset
  ) AS counted
) AS ranked
JOIN (
  SELECT
    signal.monitor AS monitor,
    signal.asset AS asset,
    CAST(SUM(CASE WHEN signal.is_above IS NULL THEN 0 ELSE 1 END) AS BIGINT) AS judged,
    CAST(SUM(CASE WHEN signal.is_above IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS not_judged,
    MIN(signal.since_time) AS since_time,
    CAST(MAX(signal.left_together) AS BIGINT) AS together,
    MAX(signal.data_time) AS data_time,
    MAX(signal.data_tick) AS data_tick
  FROM (
    SELECT
      begun.monitor AS monitor,
      begun.asset AS asset,
      begun.channel AS channel,
      MAX(begun.is_above) AS is_above,
      MAX(begun.since_time) AS since_time,
      MAX(begun.data_time) AS data_time,
      MAX(begun.data_tick) AS data_tick,
      SUM(
        CASE
          WHEN begun.since_tick IS NULL OR begun.part = 1 THEN 0
          WHEN begun.part = 2 THEN begun.begun_by
          ELSE -begun.begun_by
        END
      ) AS left_together
    FROM (
      SELECT
        fleet_row.monitor AS monitor,
        fleet_row.asset AS asset,
        fleet_row.channel AS channel,
        fleet_row.is_above AS is_above,
        fleet_row.since_time AS since_time,
        fleet_row.since_tick AS since_tick,
        fleet_row.data_time AS data_time,
        fleet_row.data_tick AS data_tick,
        each_part.part AS part,
        CAST(
          SUM(CASE WHEN each_part.part = 1 AND fleet_row.since_tick IS NOT NULL THEN 1 ELSE 0 END) OVER (
            PARTITION BY fleet_row.monitor, fleet_row.asset
            ORDER BY
              CASE WHEN each_part.part = 0 THEN fleet_row.window_from_tick ELSE fleet_row.since_tick END,
              each_part.part
            ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
          ) AS BIGINT
        ) AS begun_by
      FROM stored_fleet AS fleet_row
      CROSS JOIN (SELECT 0 AS part UNION ALL SELECT 1 AS part UNION ALL SELECT 2 AS part) AS each_part
    ) AS begun
    GROUP BY begun.monitor, begun.asset, begun.channel
  ) AS signal
  GROUP BY signal.monitor, signal.asset
) AS beside ON beside.monitor = ranked.monitor AND beside.asset = ranked.asset;

COMMENT ON VIEW stored_machine IS 'What is known of every machine now, counted over its signals';
COMMENT ON COLUMN stored_machine.monitor IS 'The monitor';
COMMENT ON COLUMN stored_machine.asset IS 'The machine';
COMMENT ON COLUMN stored_machine.signals IS 'Signals of it';
COMMENT ON COLUMN stored_machine.watched IS 'Signals that something judges: judged_by of fleet is not NULL';
COMMENT ON COLUMN stored_machine.not_watched IS 'Signals that nothing judges, as calibration does not allow it';
COMMENT ON COLUMN stored_machine.judged IS 'Signals that can be judged now: is_above of fleet is not NULL';
COMMENT ON COLUMN stored_machine.above IS 'Signals above their limit: status proving, open or high';
COMMENT ON COLUMN stored_machine.not_judged IS 'Signals that cannot be judged yet, or at all';
COMMENT ON COLUMN stored_machine.since_time
  IS 'Since when the first of those above is above (UTC); NULL if none is, or where the source counts time';
COMMENT ON COLUMN stored_machine.since_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
COMMENT ON COLUMN stored_machine.first_channel IS 'The signal that is above since then; NULL if none is';
COMMENT ON COLUMN stored_machine.strongest_channel IS 'The signal above of the largest strength; NULL if none is';
COMMENT ON COLUMN stored_machine.strength IS 'Its strength in fleet';
COMMENT ON COLUMN stored_machine.urgency IS 'The largest urgency of its signals in fleet';
COMMENT ON COLUMN stored_machine.machine_rank
  IS 'Place among the machines of the monitor, the one to be looked at first being 1: by urgency, above and strength';
COMMENT ON COLUMN stored_machine.together
  IS 'The most signals above that left health within one window of each other; 0 if none is above';
COMMENT ON COLUMN stored_machine.data_time
  IS 'Newest time read of the machine (UTC); NULL where the source counts time';
COMMENT ON COLUMN stored_machine.data_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';

-- Trend: how far the indicator of each channel moved from the window before the last to the last one, and whether
-- that is a rise to be told while the channel is not above its limit: by more than 0.01 and two standard deviations of the blocks
-- of calibration, to more than half of hi_limit.
CREATE OR REPLACE VIEW stored_trend AS
SELECT
  moved.monitor AS monitor,
  moved.asset AS asset,
  moved.channel AS channel,
  moved.version_no AS version_no,
  moved.version_id AS version_id,
  moved.rise AS rise,
  CASE
    WHEN moved.is_above IS NULL OR moved.is_above = 1 OR moved.rise IS NULL THEN 0
    WHEN moved.floor_sd IS NOT NULL AND moved.rise <= 2 * moved.floor_sd THEN 0
    WHEN moved.rise > CAST(1e-2 AS DOUBLE) AND moved.hi > moved.hi_limit / CAST(2 AS DOUBLE) THEN 1
    ELSE 0
  END AS is_rising
FROM (
  SELECT
    fleet_row.monitor AS monitor,
    fleet_row.asset AS asset,
    fleet_row.channel AS channel,
    fleet_row.version_no AS version_no,
    fleet_row.version_id AS version_id,
    fleet_row.is_above AS is_above,
    fleet_row.floor_sd AS floor_sd,
    fleet_row.hi_limit AS hi_limit,
    fleet_row.hi AS hi,
    CAST(fleet_row.novel_in_window - fleet_row.novel_window_before AS DOUBLE) / CAST(fleet_row.window_length AS DOUBLE)
      AS rise
  FROM stored_fleet AS fleet_row
) AS moved;

COMMENT ON VIEW stored_trend IS 'Whether the indicator of each channel rises that is not above its limit; one row per channel';
COMMENT ON COLUMN stored_trend.monitor IS 'The monitor';
COMMENT ON COLUMN stored_trend.asset IS 'The machine';
COMMENT ON COLUMN stored_trend.channel IS 'The signal';
COMMENT ON COLUMN stored_trend.version_no IS 'Which calibration of the channel: 1, 2, ...; the active one';
COMMENT ON COLUMN stored_trend.version_id IS 'Its key in the other tables';
COMMENT ON COLUMN stored_trend.rise
  IS 'hi less that of the window before the last; NULL until two windows are scored';
COMMENT ON COLUMN stored_trend.is_rising
  IS '1 if it is not above its limit, and hi above half of hi_limit and risen by more than 0.01 and twice floor_sd; else 0';

-- Unplaced, by day: what runs could give to no channel or instant. Ranges of runs overlap, and a row counts
-- in each that reads it: so it is the most that one run of the day found, not a sum.
CREATE OR REPLACE VIEW stored_unplaced_day AS
SELECT
  watching.name AS monitor,
  MAKE_TIMESTAMP(run_total.day_start) AS day,
  CAST(COUNT(*) AS BIGINT) AS runs,
  MAX(run_total.nameless) AS nameless,
  MAX(run_total.undated) AS undated,
  MAX(run_total.strangers) AS strangers,
  MAX(run_total.stranger_channels) AS stranger_channels
FROM (
  SELECT
    run.monitor_id AS monitor_id,
    CAST(
      FLOOR(
        (CAST(run.started AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(86400000000 AS DOUBLE)
      ) AS BIGINT
    ) * 86400000000 AS day_start,
    run.nameless AS nameless,
    run.undated AS undated,
    run.strangers AS strangers,
    run.stranger_channels AS stranger_channels
  FROM stored_unplaced AS run
  WHERE run.nameless + run.undated + run.strangers > 0
) AS run_total
JOIN stored_monitor AS watching ON watching.monitor_id = run_total.monitor_id
GROUP BY watching.name, run_total.day_start;

COMMENT ON VIEW stored_unplaced_day
  IS 'Rows that runs could give to no channel or instant, by day: the most that one run found';
COMMENT ON COLUMN stored_unplaced_day.monitor IS 'The monitor';
COMMENT ON COLUMN stored_unplaced_day.day IS 'The day on which the runs began (UTC)';
COMMENT ON COLUMN stored_unplaced_day.runs IS 'Runs of the day that found any';
COMMENT ON COLUMN stored_unplaced_day.nameless IS 'Rows without asset or channel';
COMMENT ON COLUMN stored_unplaced_day.undated IS 'Rows without a time';
COMMENT ON COLUMN stored_unplaced_day.strangers IS 'Rows of channels that have no calibration';
COMMENT ON COLUMN stored_unplaced_day.stranger_channels IS 'How many such channels there were';

-- Last run: when the last run of each monitor began, and how old it is by the clock of the database. Every run that is
-- committed leaves a row in unplaced or run, also where nothing is new.
CREATE OR REPLACE VIEW stored_last_run AS
SELECT
  watching.name AS monitor,
  MAKE_TIMESTAMP(begun.started) AS started_at,
  CASE
    WHEN begun.age > 0
      THEN CAST(FLOOR((CAST(begun.age AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(1000000 AS DOUBLE)) AS BIGINT)
    ELSE 0
  END AS age_seconds
FROM (
  SELECT
    monitor_id,
    MAX(ran.started) AS started,
    CAST(EPOCH_US(CURRENT_TIMESTAMP) AS BIGINT) - MAX(ran.started) AS age
  FROM (
    SELECT monitor_id, started
    FROM stored_unplaced
    UNION ALL
    SELECT named.monitor_id AS monitor_id, run.started AS started
    FROM stored_finished_run AS run
    JOIN stored_version AS version ON version.version_id = run.version_id
    JOIN stored_channel AS named ON named.channel_id = version.channel_id
  ) AS ran
  GROUP BY monitor_id
) AS begun
JOIN stored_monitor AS watching ON watching.monitor_id = begun.monitor_id;

COMMENT ON VIEW stored_last_run IS 'How old the last committed run of each monitor is; one row per monitor that ever ran';
COMMENT ON COLUMN stored_last_run.monitor IS 'The monitor';
COMMENT ON COLUMN stored_last_run.started_at IS 'When the run began (UTC)';
COMMENT ON COLUMN stored_last_run.age_seconds IS 'How many seconds ago that was, by the clock of the database';
