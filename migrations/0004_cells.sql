-- Cell: every cell that is known of a channel under its active version, healthy or novel, decoded into one interval of
-- the signal per axis. A key is the sum of code * R^axis with R = bins + 3 (sql/embedding/cell_term.sql): modulo
-- R^(axis + 1), less itself modulo R^axis, it is code * R^axis exactly, so the quotient needs rounding only. R^axis is
-- put together of powers of two; since R^m fits in 63 bits and axis < m, none is too large. Codes are those of
-- sql/support/code.sql.
CREATE OR REPLACE VIEW stored_cell AS
SELECT
  watching.name AS monitor,
  named.asset AS asset,
  named.channel AS channel,
  coordinate.version_no AS version_no,
  coordinate.version_id AS version_id,
  coordinate.kind AS kind,
  coordinate.cell_key AS cell_key,
  coordinate.visits AS visits,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(coordinate.first_tick) END AS first_time,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(coordinate.last_tick) END AS last_time,
  coordinate.first_tick AS first_tick,
  coordinate.last_tick AS last_tick,
  coordinate.axis AS axis,
  coordinate.samples_before AS samples_before,
  coordinate.code AS code,
  CASE
    WHEN coordinate.code = 0 THEN 'missing'
    WHEN coordinate.code = 1 THEN 'below'
    WHEN coordinate.code = coordinate.bins + 2 THEN 'above'
    ELSE 'within'
  END AS place,
  CASE
    WHEN coordinate.code < 2 THEN NULL
    WHEN coordinate.code = coordinate.bins + 2 THEN coordinate.calibrated_hi
    ELSE coordinate.calibrated_lo
      + (coordinate.calibrated_hi - coordinate.calibrated_lo)
        * CAST(coordinate.code - 2 AS DOUBLE) / CAST(coordinate.bins AS DOUBLE)
  END AS value_from,
  CASE
    WHEN coordinate.code = 0 OR coordinate.code = coordinate.bins + 2 THEN NULL
    WHEN coordinate.code = 1 THEN coordinate.calibrated_lo
    WHEN coordinate.code = coordinate.bins + 1 THEN coordinate.calibrated_hi
    ELSE coordinate.calibrated_lo
      + (coordinate.calibrated_hi - coordinate.calibrated_lo)
        * CAST(coordinate.code - 1 AS DOUBLE) / CAST(coordinate.bins AS DOUBLE)
  END AS value_to,
  coordinate.program_no AS program_no,
  CASE WHEN ran.hit = 1 THEN ran.program END AS program
FROM (
  SELECT
    along.channel_id AS channel_id,
    along.version_id AS version_id,
    along.support_id AS support_id,
    along.version_no AS version_no,
    along.bins AS bins,
    along.axis AS axis,
    along.samples_before AS samples_before,
    learnt.calibrated_lo AS calibrated_lo,
    learnt.calibrated_hi AS calibrated_hi,
    visited.kind AS kind,
    visited.cell_key AS cell_key,
    visited.visits AS visits,
    visited.first_tick AS first_tick,
    visited.last_tick AS last_tick,
    CAST(
      FLOOR(
        CAST(visited.cell_key % (along.weight * along.radix) - visited.cell_key % along.weight AS DOUBLE)
        / CAST(along.weight AS DOUBLE)
        + CAST(5e-1 AS DOUBLE)
      ) AS BIGINT
    ) AS code,
    CASE
      WHEN along.program_weight IS NULL THEN CAST(0 AS BIGINT)
      ELSE CAST(
        FLOOR(
          CAST(visited.cell_key - visited.cell_key % along.program_weight AS DOUBLE)
          / CAST(along.program_weight AS DOUBLE)
          + CAST(5e-1 AS DOUBLE)
        ) AS BIGINT
      )
    END AS program_no
  FROM (
    SELECT
      version.version_id AS version_id,
      'healthy' AS kind,
      held.cell_key AS cell_key,
      held.visits AS visits,
      held.first_time AS first_tick,
      held.last_time AS last_tick
    FROM stored_support AS held
    JOIN stored_version AS version ON version.support_id = held.support_id
    UNION ALL
    SELECT
      novel_cell.version_id AS version_id,
      'novel' AS kind,
      novel_cell.cell_key AS cell_key,
      CAST(SUM(novel_cell.visits) AS BIGINT) AS visits,
      MIN(novel_cell.first_time) AS first_tick,
      MAX(novel_cell.last_time) AS last_tick
    FROM stored_visible_novel AS novel_cell
    GROUP BY novel_cell.version_id, novel_cell.cell_key
  ) AS visited
  JOIN (
    SELECT
      version_id,
      channel_id,
      support_id,
      version_no,
      bins,
      program_weight,
      radix,
      axis,
      axis * tau AS samples_before,
      CASE
        WHEN axis < m
          THEN CASE WHEN ones = 1 THEN radix ELSE 1 END
            * CASE WHEN twos = 1 THEN power_2 ELSE 1 END
            * CASE WHEN fours = 1 THEN power_4 ELSE 1 END
            * CASE WHEN eights = 1 THEN power_8 ELSE 1 END
            * CASE WHEN sixteens = 1 THEN power_16 ELSE 1 END
        ELSE 1
      END AS weight
    FROM (
      SELECT
        version.version_id AS version_id,
        version.channel_id AS channel_id,
        version.support_id AS support_id,
        version.version_no AS version_no,
        version.m AS m,
        version.tau AS tau,
        version.bins AS bins,
        version.program_weight AS program_weight,
        version.radix AS radix,
        version.power_2 AS power_2,
        version.power_4 AS power_4,
        version.power_8 AS power_8,
        CASE WHEN version.m > 16 THEN version.power_8 * version.power_8 ELSE 1 END AS power_16,
        bit_1.ones AS ones,
        bit_2.twos AS twos,
        bit_4.fours AS fours,
        bit_8.eights AS eights,
        bit_16.sixteens AS sixteens,
        CAST(ones + 2 * twos + 4 * fours + 8 * eights + 16 * sixteens AS BIGINT) AS axis
      FROM (
        SELECT
          version_id,
          channel_id,
          support_id,
          version_no,
          m,
          tau,
          bins,
          program_weight,
          radix,
          power_2,
          power_4,
          CASE WHEN m > 8 THEN power_4 * power_4 ELSE 1 END AS power_8
        FROM (
          SELECT
            version_id,
            channel_id,
            support_id,
            version_no,
            m,
            tau,
            bins,
            program_weight,
            radix,
            power_2,
            CASE WHEN m > 4 THEN power_2 * power_2 ELSE 1 END AS power_4
          FROM (
            SELECT
              frozen.version_id AS version_id,
              frozen.channel_id AS channel_id,
              frozen.support_id AS support_id,
              frozen.version_no AS version_no,
              frozen.m AS m,
              frozen.tau AS tau,
              frozen.bins AS bins,
              frozen.program_weight AS program_weight,
              frozen.bins + 3 AS radix,
              CASE WHEN frozen.m > 2 THEN (frozen.bins + 3) * (frozen.bins + 3) ELSE 1 END AS power_2
            FROM stored_version AS frozen
            JOIN (
              SELECT channel_id, MAX(version_id) AS newest_id
              FROM stored_version
              GROUP BY channel_id
            ) AS active ON active.newest_id = frozen.version_id
          ) AS squared
        ) AS fourth
      ) AS version
      CROSS JOIN (SELECT 0 AS ones UNION ALL SELECT 1 AS ones) AS bit_1
      CROSS JOIN (SELECT 0 AS twos UNION ALL SELECT 1 AS twos) AS bit_2
      CROSS JOIN (SELECT 0 AS fours UNION ALL SELECT 1 AS fours) AS bit_4
      CROSS JOIN (SELECT 0 AS eights UNION ALL SELECT 1 AS eights) AS bit_8
      CROSS JOIN (SELECT 0 AS sixteens UNION ALL SELECT 1 AS sixteens) AS bit_16
    ) AS numbered
    WHERE axis < m
  ) AS along ON along.version_id = visited.version_id
  JOIN stored_bounds AS learnt ON learnt.support_id = along.support_id
) AS coordinate
JOIN stored_channel AS named ON named.channel_id = coordinate.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id
LEFT JOIN (
  SELECT support_id, program_no, program, 1 AS hit
  FROM stored_program
) AS ran ON ran.support_id = coordinate.support_id AND ran.program_no = coordinate.program_no;

COMMENT ON VIEW stored_cell
  IS 'Cells of each channel, healthy and novel, as one interval of the signal per axis; one row per cell and axis';
COMMENT ON COLUMN stored_cell.monitor IS 'The monitor';
COMMENT ON COLUMN stored_cell.asset IS 'The machine';
COMMENT ON COLUMN stored_cell.channel IS 'The signal';
COMMENT ON COLUMN stored_cell.version_no IS 'Which calibration of the channel: 1, 2, ...; the active one';
COMMENT ON COLUMN stored_cell.version_id IS 'Its key in the other tables';
COMMENT ON COLUMN stored_cell.kind IS 'healthy: calibration visited it; novel: visited since, and never in calibration';
COMMENT ON COLUMN stored_cell.cell_key IS 'The cell: its codes on the m axes, as one integer';
COMMENT ON COLUMN stored_cell.visits IS 'Vectors in it: of calibration, or scored ones of the buckets that are kept';
COMMENT ON COLUMN stored_cell.first_time
  IS 'Time of the first visit (UTC); NULL where the source counts time, see first_tick';
COMMENT ON COLUMN stored_cell.last_time
  IS 'Time of the last visit (UTC); NULL where the source counts time, see last_tick';
COMMENT ON COLUMN stored_cell.first_tick
  IS 'Time of the first visit: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_cell.last_tick
  IS 'Time of the last visit: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_cell.axis IS 'Which coordinate: 0 is the newest sample of the vector';
COMMENT ON COLUMN stored_cell.samples_before IS 'How many samples before the newest it lies: axis * tau';
COMMENT ON COLUMN stored_cell.code IS 'Its code: 0 missing, 1 below, 2 to bins + 1 the bins, bins + 2 above';
COMMENT ON COLUMN stored_cell.place
  IS 'missing: no reading; below or above the range of calibration; within: in the bin from value_from to value_to';
COMMENT ON COLUMN stored_cell.value_from IS 'Lower end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_cell.value_to IS 'Upper end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_cell.program_no IS 'Number of the program that it is of; 0 where states are of no program';
COMMENT ON COLUMN stored_cell.program IS 'The program that it is of; NULL where states are of no program';

-- Unjudged program: what machines ran since calibration that it holds too little of, or nothing: its readings are not
-- judged. Only what is kept is counted.
CREATE OR REPLACE VIEW stored_unjudged_program AS
SELECT
  watching.name AS monitor,
  named.asset AS asset,
  named.channel AS channel,
  version.version_no AS version_no,
  ran.program AS program,
  CASE WHEN learnt.hit = 1 THEN 'needs_data' ELSE 'unknown' END AS verdict,
  ran.readings AS readings,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(ran.first_tick) END AS first_time,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(ran.last_tick) END AS last_time,
  ran.first_tick AS first_tick,
  ran.last_tick AS last_tick
FROM (
  SELECT
    version_id,
    program,
    CAST(SUM(counted.readings) AS BIGINT) AS readings,
    MIN(first_time) AS first_tick,
    MAX(last_time) AS last_tick
  FROM stored_visible_program AS counted
  GROUP BY version_id, program
) AS ran
JOIN stored_version AS version ON version.version_id = ran.version_id
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS active ON active.newest_id = version.version_id
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id
LEFT JOIN (
  SELECT support_id, program, 1 AS hit
  FROM stored_program
) AS learnt ON learnt.support_id = version.support_id AND learnt.program = ran.program;

COMMENT ON VIEW stored_unjudged_program
  IS 'Programs that calibration holds too little of, or nothing, as machines ran them since; active versions only';
COMMENT ON COLUMN stored_unjudged_program.monitor IS 'The monitor';
COMMENT ON COLUMN stored_unjudged_program.asset IS 'The machine';
COMMENT ON COLUMN stored_unjudged_program.channel IS 'The signal';
COMMENT ON COLUMN stored_unjudged_program.version_no IS 'Which calibration of the channel: 1, 2, ...';
COMMENT ON COLUMN stored_unjudged_program.program IS 'What the machine ran; NULL where nothing says so';
COMMENT ON COLUMN stored_unjudged_program.verdict
  IS 'unknown: calibration does not hold it; needs_data: it holds too little of it';
COMMENT ON COLUMN stored_unjudged_program.readings IS 'Readings that were not judged, missing ones left out';
COMMENT ON COLUMN stored_unjudged_program.first_time
  IS 'Time of the first of them (UTC); NULL where the source counts time, see first_tick';
COMMENT ON COLUMN stored_unjudged_program.last_time
  IS 'Time of the last of them (UTC); NULL where the source counts time, see last_tick';
COMMENT ON COLUMN stored_unjudged_program.first_tick
  IS 'Time of the first of them: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_unjudged_program.last_tick
  IS 'Time of the last of them: microseconds since 1970 (UTC), or the counter of the source';

-- Quarantine: the states that calibration never visited and the machine has visited since, one row per
-- channel and cell, under the active version: what explains a raised indicator, and what a recalibration
-- would have to take in. Only what is kept is counted; gam prune drops old buckets.
CREATE OR REPLACE VIEW stored_quarantine AS
SELECT
  watching.name AS monitor,
  named.asset AS asset,
  named.channel AS channel,
  version.version_no AS version_no,
  held.cell_key AS cell_key,
  held.visits AS visits,
  held.buckets AS buckets,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(held.first_tick) END AS first_time,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(held.last_tick) END AS last_time,
  held.first_tick AS first_tick,
  held.last_tick AS last_tick
FROM (
  SELECT
    version_id,
    cell_key,
    CAST(SUM(cell.visits) AS BIGINT) AS visits,
    CAST(COUNT(*) AS BIGINT) AS buckets,
    MIN(first_time) AS first_tick,
    MAX(last_time) AS last_tick
  FROM stored_visible_novel AS cell
  GROUP BY version_id, cell_key
) AS held
JOIN stored_version AS version ON version.version_id = held.version_id
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS active ON active.newest_id = version.version_id
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id;

COMMENT ON VIEW stored_quarantine
  IS 'Cells visited since calibration that it never visited, active versions only';
COMMENT ON COLUMN stored_quarantine.monitor IS 'The monitor';
COMMENT ON COLUMN stored_quarantine.asset IS 'The machine';
COMMENT ON COLUMN stored_quarantine.channel IS 'The signal';
COMMENT ON COLUMN stored_quarantine.version_no IS 'Which calibration of the channel: 1, 2, ...';
COMMENT ON COLUMN stored_quarantine.cell_key IS 'The cell: its codes on the m axes, as one integer';
COMMENT ON COLUMN stored_quarantine.visits IS 'Scored vectors in it';
COMMENT ON COLUMN stored_quarantine.buckets IS 'Buckets in which it was visited';
COMMENT ON COLUMN stored_quarantine.first_time
  IS 'Time of the first visit (UTC); NULL where the source counts time, see first_tick';
COMMENT ON COLUMN stored_quarantine.last_time
  IS 'Time of the last visit (UTC); NULL where the source counts time, see last_tick';
COMMENT ON COLUMN stored_quarantine.first_tick
  IS 'Time of the first visit: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_quarantine.last_tick
  IS 'Time of the last visit: microseconds since 1970 (UTC), or the counter of the source';

-- Growth: how many cells are known of each channel by then, one row per block of calibration and one per full
-- bucket, under the active version: cells of the support, and new ones. Of new ones only those that are kept count.
CREATE OR REPLACE VIEW stored_growth AS
SELECT
  watching.name AS monitor,
  named.asset AS asset,
  named.channel AS channel,
  version.version_no AS version_no,
  growth.phase AS phase,
  growth.number AS number,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(growth.last_tick) END AS last_time,
  growth.last_tick AS last_tick,
  growth.healthy AS healthy,
  growth.novel AS novel
FROM (
  SELECT
    version.version_id AS version_id,
    'calibration' AS phase,
    part.block AS number,
    part.last_time AS last_tick,
    CAST(SUM(CASE WHEN cell.first_time <= part.last_time THEN 1 ELSE 0 END) AS BIGINT) AS healthy,
    CAST(0 AS BIGINT) AS novel
  FROM stored_version AS version
  JOIN stored_block AS part ON part.support_id = version.support_id AND part.channel_id = version.channel_id
  JOIN stored_support AS cell ON cell.support_id = version.support_id
  GROUP BY version.version_id, part.block, part.last_time
  UNION ALL
  SELECT
    full_bucket.version_id AS version_id,
    'scored' AS phase,
    full_bucket.bucket_no AS number,
    full_bucket.last_time AS last_tick,
    learnt.cells AS healthy,
    CAST(
      SUM(CASE WHEN first_novel.hit = 1 THEN first_novel.cells ELSE 0 END) OVER (
        PARTITION BY full_bucket.version_id
        ORDER BY full_bucket.bucket_no
        ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS novel
  FROM stored_visible_bucket AS full_bucket
  JOIN stored_version AS version ON version.version_id = full_bucket.version_id
  JOIN stored_bounds AS learnt ON learnt.support_id = version.support_id
  LEFT JOIN (
    SELECT version_id, first_no, CAST(COUNT(*) AS BIGINT) AS cells, 1 AS hit
    FROM (
      SELECT version_id, cell_key, MIN(bucket_no) AS first_no
      FROM stored_visible_novel
      GROUP BY version_id, cell_key
    ) AS seen
    GROUP BY version_id, first_no
  ) AS first_novel ON first_novel.version_id = full_bucket.version_id AND first_novel.first_no = full_bucket.bucket_no
) AS growth
JOIN stored_version AS version ON version.version_id = growth.version_id
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS active ON active.newest_id = version.version_id
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id;

COMMENT ON VIEW stored_growth
  IS 'Cells known of each channel by then, active versions only; one row per block of calibration and per bucket';
COMMENT ON COLUMN stored_growth.monitor IS 'The monitor';
COMMENT ON COLUMN stored_growth.asset IS 'The machine';
COMMENT ON COLUMN stored_growth.channel IS 'The signal';
COMMENT ON COLUMN stored_growth.version_no IS 'Which calibration of the channel: 1, 2, ...';
COMMENT ON COLUMN stored_growth.phase IS 'calibration: a block of it; scored: a full bucket';
COMMENT ON COLUMN stored_growth.number IS 'Number of the block or of the bucket';
COMMENT ON COLUMN stored_growth.last_time
  IS 'Time of its last vector (UTC); NULL where the source counts time, see last_tick';
COMMENT ON COLUMN stored_growth.last_tick
  IS 'Time of its last vector: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_growth.healthy IS 'Cells of the support that were visited by then';
COMMENT ON COLUMN stored_growth.novel IS 'Different cells outside the support that were visited by then, of those kept';
