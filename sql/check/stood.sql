-- Stood: how much of calibration counts as still (alarms, section 1), by still_after as it is set, else by what would
-- be proposed. Only channels in which a value stays at all pay for this, up to the end of their calibration.
-- Reads:  samples, channels, limits, calibration, movements, pauses
-- A row:  one channel in which two samples in a row are equal; calibration_still counts samples, still_runs the runs of
--         equal ones that become still there, longest_run the samples of the longest of them up to its last one there.
-- Slots:  :still_after  as it is set for the channel, NULL where it is not
--         :max_gap      likewise
--         :least        proposed samples at least
--         :lasting      a length of time that they last at least; 0 for a counter
SELECT
  counted.channel_id AS channel_id,
  MIN(counted.still_after) AS still_after,
  CAST(SUM(CASE WHEN counted.run >= counted.still_after THEN 1 ELSE 0 END) AS BIGINT) AS calibration_still,
  CAST(SUM(CASE WHEN counted.run = counted.still_after THEN 1 ELSE 0 END) AS BIGINT) AS still_runs,
  MAX(CASE WHEN counted.run >= counted.still_after THEN counted.run END) AS longest_run
FROM (
  SELECT
    stretched.channel_id AS channel_id,
    stretched.time AS time,
    stretched.still_after AS still_after,
    stretched.position - MAX(CASE WHEN stretched.moving = 1 THEN stretched.position END) OVER (
      PARTITION BY stretched.channel_id
      ORDER BY stretched.position
      ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) + 1 AS run
  FROM (
    SELECT
      beside.channel_id AS channel_id,
      beside.time AS time,
      beside.position AS position,
      beside.still_after AS still_after,
      CASE
        WHEN beside.max_gap IS NOT NULL AND beside.time - beside.previous_time > beside.max_gap THEN 1
        WHEN beside.position > 1 AND beside.value = beside.previous_value THEN 0
        ELSE 1
      END AS moving
    FROM (
      SELECT
        sampled.channel_id AS channel_id,
        sampled.time AS time,
        sampled.value AS value,
        named.still_after AS still_after,
        named.max_gap AS max_gap,
        CAST(
          ROW_NUMBER() OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time) AS BIGINT
        ) AS position,
        LAG(sampled.value, 1) OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time) AS previous_value,
        LAG(sampled.time, 1) OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time) AS previous_time
      FROM samples AS sampled
      JOIN (
        SELECT
          settled.channel_id AS channel_id,
          settled.max_gap AS max_gap,
          settled.calibration_end AS calibration_end,
          CASE
            WHEN settled.still_after IS NOT NULL THEN settled.still_after
            WHEN settled.lasting > CAST(:least AS BIGINT) THEN settled.lasting
            ELSE CAST(:least AS BIGINT)
          END AS still_after
        FROM (
          SELECT
            channel_row.channel_id AS channel_id,
            edge.calibration_end AS calibration_end,
            CAST(:still_after AS BIGINT) AS still_after,
            CAST(:max_gap AS BIGINT) AS max_gap,
            CAST(
              FLOOR((CAST(:lasting AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(spaced.typical_step AS DOUBLE))
              AS BIGINT
            ) AS lasting
          FROM channels AS channel_row
          JOIN movements AS movement ON movement.channel_id = channel_row.channel_id
          JOIN pauses AS spaced ON spaced.channel_id = channel_row.channel_id
          JOIN limits AS edge ON edge.channel_id = channel_row.channel_id
          WHERE movement.stills > 0
        ) AS settled
      ) AS named ON named.channel_id = sampled.channel_id
      WHERE sampled.time <= named.calibration_end
    ) AS beside
  ) AS stretched
) AS counted
JOIN calibration AS piece ON piece.channel_id = counted.channel_id
WHERE counted.time BETWEEN piece.time_from AND piece.time_to
GROUP BY counted.channel_id
