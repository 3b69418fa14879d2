-- Selected: the samples from which parameters are chosen: those of calibration, in order, in runs that
-- neither a break nor a sample outside calibration interrupts (method, section 8).
-- Reads:  samples, bounds, calibration
-- A row:  one calibration sample, missing if it was left out of the range; place counts them, run_no counts the runs, both from 1. scaled is
--         (x - lo) / (hi - lo), NULL where the sample is missing or the channel constant; level is the
--         same as an integer of 14 bits, 1 to 16384, and 0 where the sample is missing.
-- Slots:  :max_gap  the longest step inside a segment, in the unit of time; NULL where none ends
SELECT
  channel_id,
  place,
  CAST(
    SUM(
      CASE
        WHEN place = 1 OR breaking = 1 OR position - previous_position > 1 THEN 1
        ELSE 0
      END
    ) OVER (
      PARTITION BY channel_id ORDER BY place ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS BIGINT
  ) AS run_no,
  scaled,
  CAST(
    CASE
      WHEN scaled >= CAST(1 AS DOUBLE) THEN 16384
      WHEN scaled >= CAST(0 AS DOUBLE) THEN 1 + FLOOR(scaled * CAST(16384 AS DOUBLE))
      WHEN in_range = 1 THEN 1
      ELSE 0
    END AS SMALLINT
  ) AS level
FROM (
  SELECT
    channel_id,
    position,
    breaking,
    scaled,
    in_range,
    CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY position) AS BIGINT) AS place,
    LAG(position, 1) OVER (PARTITION BY channel_id ORDER BY position) AS previous_position
  FROM (
    SELECT
      sampled.channel_id AS channel_id,
      CAST(
        ROW_NUMBER() OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time) AS BIGINT
      ) AS position,
      CASE WHEN piece.hit = 1 THEN 1 ELSE 0 END AS calibrating,
      CASE
        WHEN sampled.time - LAG(sampled.time, 1) OVER (
          PARTITION BY sampled.channel_id ORDER BY sampled.time
        ) > :max_gap THEN 1
        ELSE 0
      END AS breaking,
      CASE
        WHEN sampled.value BETWEEN scale.calibrated_lo AND scale.calibrated_hi
          THEN (sampled.value - scale.calibrated_lo) / NULLIF(scale.calibrated_hi - scale.calibrated_lo, CAST(0 AS DOUBLE))
      END AS scaled,
      CASE WHEN sampled.value BETWEEN scale.calibrated_lo AND scale.calibrated_hi THEN 1 ELSE 0 END AS in_range
    FROM samples AS sampled
    JOIN bounds AS scale ON scale.channel_id = sampled.channel_id
    LEFT JOIN (
      SELECT channel_id, time_from, time_to, 1 AS hit
      FROM calibration
    ) AS piece
      ON piece.channel_id = sampled.channel_id
      AND sampled.time BETWEEN piece.time_from AND piece.time_to
    WHERE sampled.time <= scale.calibration_end
  ) AS numbered
  WHERE calibrating = 1
) AS ordered
