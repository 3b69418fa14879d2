-- Machine: what is known of every machine now, one row each, counted over its signals in fleet. Together counts the
-- signals whose onset lies within the window that ended at the onset of one of them.
CREATE OR REPLACE VIEW stored_machine AS
SELECT
  counted.monitor AS monitor,
  counted.asset AS asset,
  counted.signals AS signals,
  counted.judged AS judged,
  counted.above AS above,
  counted.not_judged AS not_judged,
  counted.since_time AS since_time,
  counted.since_tick AS since_tick,
  CASE WHEN nearby.hit = 1 THEN nearby.together ELSE 0 END AS together,
  counted.data_time AS data_time,
  counted.data_tick AS data_tick
FROM (
  SELECT
    monitor,
    asset,
    CAST(COUNT(*) AS BIGINT) AS signals,
    CAST(SUM(CASE WHEN status IN ('high', 'ok') THEN 1 ELSE 0 END) AS BIGINT) AS judged,
    CAST(SUM(CASE WHEN status = 'high' THEN 1 ELSE 0 END) AS BIGINT) AS above,
    CAST(SUM(CASE WHEN status IN ('high', 'ok') THEN 0 ELSE 1 END) AS BIGINT) AS not_judged,
    MIN(member.since_time) AS since_time,
    MIN(member.since_tick) AS since_tick,
    MAX(member.data_time) AS data_time,
    MAX(member.data_tick) AS data_tick
  FROM stored_fleet AS member
  GROUP BY monitor, asset
) AS counted
JOIN stored_monitor AS watching ON watching.name = counted.monitor
LEFT JOIN (
  SELECT each_onset.monitor_id AS monitor_id, each_onset.asset AS asset, MAX(left_together) AS together, 1 AS hit
  FROM (
    SELECT
      one.monitor_id AS monitor_id,
      one.asset AS asset,
      one.version_id AS version_id,
      CAST(COUNT(*) AS BIGINT) AS left_together
    FROM (
      SELECT
        named.monitor_id AS monitor_id,
        named.asset AS asset,
        onset.version_id AS version_id,
        onset.since_tick AS since_tick,
        onset.window_from_tick AS window_from_tick
      FROM stored_onset AS onset
      JOIN stored_version AS version ON version.version_id = onset.version_id
      JOIN (
        SELECT channel_id, MAX(version_id) AS newest_id
        FROM stored_version
        GROUP BY channel_id
      ) AS active ON active.newest_id = version.version_id
      JOIN stored_channel AS named ON named.channel_id = version.channel_id
      WHERE onset.since_tick IS NOT NULL
    ) AS one
    JOIN (
      SELECT
        named.monitor_id AS monitor_id,
        named.asset AS asset,
        onset.version_id AS version_id,
        onset.since_tick AS since_tick,
        onset.window_from_tick AS window_from_tick
      FROM stored_onset AS onset
      JOIN stored_version AS version ON version.version_id = onset.version_id
      JOIN (
        SELECT channel_id, MAX(version_id) AS newest_id
        FROM stored_version
        GROUP BY channel_id
      ) AS active ON active.newest_id = version.version_id
      JOIN stored_channel AS named ON named.channel_id = version.channel_id
      WHERE onset.since_tick IS NOT NULL
    ) AS other ON other.monitor_id = one.monitor_id AND other.asset = one.asset
    WHERE other.since_tick >= one.window_from_tick AND other.since_tick <= one.since_tick
    GROUP BY one.monitor_id, one.asset, one.version_id
  ) AS each_onset
  GROUP BY each_onset.monitor_id, each_onset.asset
) AS nearby ON nearby.monitor_id = watching.monitor_id AND nearby.asset = counted.asset;

COMMENT ON VIEW stored_machine IS 'What is known of every machine now, counted over its signals';
COMMENT ON COLUMN stored_machine.monitor IS 'The monitor';
COMMENT ON COLUMN stored_machine.asset IS 'The machine';
COMMENT ON COLUMN stored_machine.signals IS 'Signals of it';
COMMENT ON COLUMN stored_machine.judged IS 'Signals that have a limit and a full window: status high or ok';
COMMENT ON COLUMN stored_machine.above IS 'Signals above their limit: status high';
COMMENT ON COLUMN stored_machine.not_judged IS 'Signals that cannot be judged yet, or at all: every other status';
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
