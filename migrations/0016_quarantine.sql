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
