-- Watched: is a channel watched, and is it silent? This is the one place that says it. A channel is watched where its
-- calibration lets it be judged, a run has read rows of it, it is not silent, and the fleet as a whole still sends. It
-- is silent where its newest row lies more than park_after behind the newest of the fleet, which is never later than
-- now, or where a run looked and no row was ever there.
-- Reads:  status_rows, last_data
-- A row:  one channel under its active version; last_data and newest_data (of the fleet) are integer time, NULL where
--         there is none. is_fed is 0 where the newest row of the fleet lies more than park_after before now.
-- Slots:  :now         this instant; 2^62 where the source counts time
--         :has_clock   1, or 0 where the source counts time
--         :park_after  in the unit of time; 2^62 for never
SELECT
  held.version_id AS version_id,
  held.last_data AS last_data,
  held.newest_data AS newest_data,
  held.is_looked_at AS is_looked_at,
  held.is_silent AS is_silent,
  held.is_fed AS is_fed,
  CASE
    WHEN held.is_judged = 1 AND held.last_data IS NOT NULL AND held.is_silent = 0 AND held.is_fed = 1 THEN 1
    ELSE 0
  END AS is_watched
FROM (
  SELECT
    version.version_id AS version_id,
    version.is_judged AS is_judged,
    version.is_looked_at AS is_looked_at,
    version.last_data AS last_data,
    version.newest_data AS newest_data,
    CASE
      WHEN version.is_looked_at = 0 THEN 0
      WHEN version.last_data IS NULL AND CAST(:park_after AS BIGINT) < 4611686018427387904 THEN 1
      WHEN version.newest_data - version.last_data > CAST(:park_after AS BIGINT) THEN 1
      ELSE 0
    END AS is_silent,
    CASE
      WHEN CAST(:has_clock AS BIGINT) = 1
        AND CAST(:now AS BIGINT) - version.newest_data > CAST(:park_after AS BIGINT)
        THEN 0
      ELSE 1
    END AS is_fed
  FROM (
    SELECT
      status_row.version_id AS version_id,
      CASE WHEN status_row.judged_by IS NOT NULL THEN 1 ELSE 0 END AS is_judged,
      CASE WHEN status_row.looked_at IS NOT NULL THEN 1 ELSE 0 END AS is_looked_at,
      CASE WHEN reading.hit = 1 THEN reading.last_data END AS last_data,
      CASE WHEN fleet.channels > 0 THEN fleet.newest_data END AS newest_data
    FROM status_rows AS status_row
    CROSS JOIN (
      SELECT
        CAST(COUNT(*) AS BIGINT) AS channels,
        MAX(CASE WHEN every.last_data > CAST(:now AS BIGINT) THEN CAST(:now AS BIGINT) ELSE every.last_data END)
          AS newest_data
      FROM last_data AS every
    ) AS fleet
    LEFT JOIN (
      SELECT version_id, last_data, 1 AS hit
      FROM last_data
    ) AS reading ON reading.version_id = status_row.version_id
  ) AS version
) AS held
