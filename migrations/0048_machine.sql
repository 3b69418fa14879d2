-- Machine: what is known of every machine now, one row each, counted over its signals in fleet. Together counts the
-- signals whose onset lies within the window that ended at the onset of one of them: those that began by then, less those
-- that began before that window. Each signal is there three times for it: where its window begins, as one that
-- began, and where it counts.
CREATE OR REPLACE VIEW stored_machine AS
SELECT
  member.monitor AS monitor,
  member.asset AS asset,
  CAST(COUNT(*) AS BIGINT) AS signals,
  CAST(SUM(CASE WHEN member.is_above IS NULL THEN 0 ELSE 1 END) AS BIGINT) AS judged,
  CAST(SUM(CASE WHEN member.is_above = 1 THEN 1 ELSE 0 END) AS BIGINT) AS above,
  CAST(SUM(CASE WHEN member.is_above IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS not_judged,
  MIN(member.since_time) AS since_time,
  MIN(member.since_tick) AS since_tick,
  CAST(MAX(member.left_together) AS BIGINT) AS together,
  MAX(member.data_time) AS data_time,
  MAX(member.data_tick) AS data_tick
FROM (
  SELECT
    begun.monitor AS monitor,
    begun.asset AS asset,
    begun.channel AS channel,
    MAX(begun.is_above) AS is_above,
    MAX(begun.since_time) AS since_time,
    MAX(begun.since_tick) AS since_tick,
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
      known.monitor AS monitor,
      known.asset AS asset,
      known.channel AS channel,
      known.is_above AS is_above,
      known.since_time AS since_time,
      known.since_tick AS since_tick,
      known.data_time AS data_time,
      known.data_tick AS data_tick,
      each_part.part AS part,
      CAST(
        SUM(CASE WHEN each_part.part = 1 AND known.since_tick IS NOT NULL THEN 1 ELSE 0 END) OVER (
          PARTITION BY known.monitor, known.asset
          ORDER BY CASE WHEN each_part.part = 0 THEN known.window_from_tick ELSE known.since_tick END, each_part.part
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS begun_by
    FROM stored_fleet AS known
    CROSS JOIN (SELECT 0 AS part UNION ALL SELECT 1 AS part UNION ALL SELECT 2 AS part) AS each_part
  ) AS begun
  GROUP BY begun.monitor, begun.asset, begun.channel
) AS member
GROUP BY member.monitor, member.asset;

COMMENT ON VIEW stored_machine IS 'What is known of every machine now, counted over its signals';
COMMENT ON COLUMN stored_machine.monitor IS 'The monitor';
COMMENT ON COLUMN stored_machine.asset IS 'The machine';
COMMENT ON COLUMN stored_machine.signals IS 'Signals of it';
COMMENT ON COLUMN stored_machine.judged IS 'Signals that can be judged now: is_above of fleet is not NULL';
COMMENT ON COLUMN stored_machine.above IS 'Signals above their limit: status proving, open or high';
COMMENT ON COLUMN stored_machine.not_judged IS 'Signals that cannot be judged yet, or at all';
COMMENT ON COLUMN stored_machine.since_time
  IS 'Since when the first of those above is above (UTC); NULL if none is, or where the source counts time';
COMMENT ON COLUMN stored_machine.since_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
COMMENT ON COLUMN stored_machine.together
  IS 'The most signals above that left health within one window of each other; 0 if none is above';
COMMENT ON COLUMN stored_machine.data_time
  IS 'Newest time read of the machine (UTC); NULL where the source counts time';
COMMENT ON COLUMN stored_machine.data_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
