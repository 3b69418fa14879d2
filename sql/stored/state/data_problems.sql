-- Data problems: what is wrong with the data of a monitor, which is no trouble of a machine. This is the one place that
-- lists it: silent, late, lost, calibration (rows came into it afterwards), constant (in health, and it moves now),
-- no_data (nothing to learn from), and of the monitor as a whole outage (its newest row is older than park_after, or more
-- than half of the channels would be silent at once: then no single one is) and unwatched (nothing is). Beside it,
-- left_out_rows lists rows that are ahead or unknown, and jumps counters that jumped.
-- Reads:  status_rows, watched, differing_contexts
-- A row:  one problem of one channel, or of the monitor, where version_id is NULL. affected: rows (late, lost,
--         calibration), channels (outage, unwatched) or novel vectors of the last window (constant), NULL where nothing
--         is counted; total: channels that it is of (outage, unwatched). since and until: integer time.
SELECT
  'outage' AS kind,
  CAST(NULL AS BIGINT) AS version_id,
  CASE WHEN fleet.is_fed = 0 THEN fleet.channels ELSE fleet.silent END AS affected,
  fleet.channels AS total,
  fleet.newest_data AS since,
  CAST(NULL AS BIGINT) AS until
FROM (
  SELECT
    CAST(COUNT(*) AS BIGINT) AS channels,
    CAST(SUM(every.is_silent) AS BIGINT) AS silent,
    MIN(every.is_fed) AS is_fed,
    MAX(every.newest_data) AS newest_data
  FROM watched AS every
  WHERE every.is_looked_at = 1
) AS fleet
WHERE fleet.channels > 0 AND (fleet.is_fed = 0 OR 2 * fleet.silent > fleet.channels)
UNION ALL
SELECT
  'silent' AS kind,
  gone.version_id AS version_id,
  CAST(NULL AS BIGINT) AS affected,
  CAST(NULL AS BIGINT) AS total,
  gone.last_data AS since,
  gone.newest_data AS until
FROM watched AS gone
CROSS JOIN (
  SELECT CAST(COUNT(*) AS BIGINT) AS channels, CAST(SUM(every.is_silent) AS BIGINT) AS silent
  FROM watched AS every
  WHERE every.is_looked_at = 1
) AS fleet
WHERE gone.is_silent = 1 AND 2 * fleet.silent <= fleet.channels
UNION ALL
SELECT
  differing.kind AS kind,
  differing.version_id AS version_id,
  differing.differing AS affected,
  CAST(NULL AS BIGINT) AS total,
  differing.since AS since,
  differing.until AS until
FROM differing_contexts AS differing
UNION ALL
SELECT
  'calibration' AS kind,
  learnt.version_id AS version_id,
  learnt.calibration_rows_added AS affected,
  CAST(NULL AS BIGINT) AS total,
  CAST(NULL AS BIGINT) AS since,
  CAST(NULL AS BIGINT) AS until
FROM status_rows AS learnt
WHERE learnt.calibration_rows_added > 0
UNION ALL
SELECT
  'constant' AS kind,
  moved.version_id AS version_id,
  CASE WHEN moved.novel_in_window IS NOT NULL THEN moved.novel_in_window ELSE moved.novel_in_buckets END AS affected,
  CAST(NULL AS BIGINT) AS total,
  CAST(NULL AS BIGINT) AS since,
  moved.last_time AS until
FROM status_rows AS moved
WHERE moved.verdict = 'constant'
  AND CASE WHEN moved.novel_in_window IS NOT NULL THEN moved.novel_in_window ELSE moved.novel_in_buckets END > 0
UNION ALL
SELECT
  'no_data' AS kind,
  blank.version_id AS version_id,
  CAST(NULL AS BIGINT) AS affected,
  CAST(NULL AS BIGINT) AS total,
  CAST(NULL AS BIGINT) AS since,
  CAST(NULL AS BIGINT) AS until
FROM status_rows AS blank
WHERE blank.verdict = 'no_data'
UNION ALL
SELECT
  'unwatched' AS kind,
  CAST(NULL AS BIGINT) AS version_id,
  fleet.channels AS affected,
  fleet.channels AS total,
  CAST(NULL AS BIGINT) AS since,
  CAST(NULL AS BIGINT) AS until
FROM (
  SELECT
    CAST(COUNT(*) AS BIGINT) AS channels,
    CAST(COUNT(CASE WHEN every.is_watched = 1 THEN 1 END) AS BIGINT) AS watched,
    CAST(COUNT(CASE WHEN every.is_silent = 1 OR every.is_fed = 0 THEN 1 END) AS BIGINT) AS unheard
  FROM watched AS every
) AS fleet
WHERE fleet.watched = 0 AND fleet.unheard = 0
