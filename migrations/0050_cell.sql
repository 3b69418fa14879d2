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
  placed.version_no AS version_no,
  placed.version_id AS version_id,
  placed.kind AS kind,
  placed.cell_key AS cell_key,
  placed.visits AS visits,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(placed.first_tick) END AS first_time,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(placed.last_tick) END AS last_time,
  placed.first_tick AS first_tick,
  placed.last_tick AS last_tick,
  placed.axis AS axis,
  placed.samples_before AS samples_before,
  placed.code AS code,
  CASE
    WHEN placed.code = 0 THEN 'missing'
    WHEN placed.code = 1 THEN 'below'
    WHEN placed.code = placed.bins + 2 THEN 'above'
    ELSE 'within'
  END AS place,
  CASE
    WHEN placed.code < 2 THEN NULL
    WHEN placed.code = placed.bins + 2 THEN placed.calibrated_hi
    ELSE placed.calibrated_lo
      + (placed.calibrated_hi - placed.calibrated_lo) * CAST(placed.code - 2 AS DOUBLE) / CAST(placed.bins AS DOUBLE)
  END AS value_from,
  CASE
    WHEN placed.code = 0 OR placed.code = placed.bins + 2 THEN NULL
    WHEN placed.code = 1 THEN placed.calibrated_lo
    WHEN placed.code = placed.bins + 1 THEN placed.calibrated_hi
    ELSE placed.calibrated_lo
      + (placed.calibrated_hi - placed.calibrated_lo) * CAST(placed.code - 1 AS DOUBLE) / CAST(placed.bins AS DOUBLE)
  END AS value_to
FROM (
  SELECT
    along.channel_id AS channel_id,
    along.version_id AS version_id,
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
    ) AS code
  FROM (
    SELECT
      made.version_id AS version_id,
      'healthy' AS kind,
      held.cell_key AS cell_key,
      held.visits AS visits,
      held.first_time AS first_tick,
      held.last_time AS last_tick
    FROM stored_support AS held
    JOIN stored_version AS made ON made.support_id = held.support_id
    UNION ALL
    SELECT
      found.version_id AS version_id,
      'novel' AS kind,
      found.cell_key AS cell_key,
      CAST(SUM(found.visits) AS BIGINT) AS visits,
      MIN(found.first_time) AS first_tick,
      MAX(found.last_time) AS last_tick
    FROM stored_visible_novel AS found
    GROUP BY found.version_id, found.cell_key
  ) AS visited
  JOIN (
    SELECT
      version_id,
      channel_id,
      support_id,
      version_no,
      bins,
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
) AS placed
JOIN stored_channel AS named ON named.channel_id = placed.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id;

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
