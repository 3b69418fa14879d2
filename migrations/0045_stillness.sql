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
