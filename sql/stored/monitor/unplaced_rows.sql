-- Unplaced rows: the rows of the range of a run that it gave to no channel or instant.
-- Reads:  names, undated, clock, stored_channel
-- A row:  the only one.
-- Slots:  :monitor_id
SELECT
  CAST(:monitor_id AS BIGINT) AS monitor_id,
  watch.started AS started,
  counted.nameless AS nameless,
  missing.absent + missing.endless + missing.skipped AS undated,
  counted.strangers AS strangers,
  counted.stranger_channels AS stranger_channels
FROM clock AS watch
CROSS JOIN undated AS missing
CROSS JOIN (
  SELECT
    CAST(
      COALESCE(SUM(CASE WHEN seen.asset IS NULL OR seen.channel IS NULL THEN seen.readings + seen.without_time END), 0)
      AS BIGINT
    ) AS nameless,
    CAST(
      COALESCE(
        SUM(CASE WHEN seen.asset IS NULL OR seen.channel IS NULL OR watched.hit = 1 THEN 0 ELSE seen.readings END), 0
      ) AS BIGINT
    ) AS strangers,
    CAST(
      COALESCE(
        SUM(
          CASE
            WHEN seen.asset IS NULL OR seen.channel IS NULL OR watched.hit = 1 OR seen.readings = 0 THEN 0
            ELSE 1
          END
        ),
        0
      ) AS BIGINT
    ) AS stranger_channels
  FROM names AS seen
  LEFT JOIN (
    SELECT named.asset AS asset, named.channel AS channel, 1 AS hit
    FROM stored_channel AS named
    WHERE named.monitor_id = :monitor_id
  ) AS watched ON watched.asset = seen.asset AND watched.channel = seen.channel
) AS counted
