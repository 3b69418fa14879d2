-- Edges: the slices of each channel in order, and which of them must be read sample by sample: those that may
-- hold one of the last samples of calibration (method, section 4). All others lie within it or after it.
-- Reads:  slices, channels, rules
-- A row:  one slice of one channel; is_edge = 1 if it must be read. quota is the number of its calibration
--         samples where that is a fraction.
-- Slots:  :reach  samples up to the last one of calibration that are asked for, at least 1
SELECT
  channel_id,
  first_time,
  last_time,
  samples,
  lowest,
  highest,
  samples_before,
  quota,
  CASE
    WHEN quota IS NOT NULL
      THEN CASE
        WHEN samples_before < quota AND samples_before + samples > quota - :reach THEN 1
        ELSE 0
      END
    WHEN first_time <= calibration_end AND samples_before + samples > samples_inside - :reach THEN 1
    ELSE 0
  END AS is_edge
FROM (
  SELECT
    channel_id,
    first_time,
    last_time,
    samples,
    lowest,
    highest,
    samples_before,
    quota,
    calibration_end,
    CAST(
      SUM(CASE WHEN last_time <= calibration_end THEN samples ELSE 0 END) OVER (
        PARTITION BY channel_id
      ) AS BIGINT
    ) AS samples_inside
  FROM (
    SELECT
      named.channel_id AS channel_id,
      part.earliest AS first_time,
      part.latest AS last_time,
      part.readings AS samples,
      part.lowest AS lowest,
      part.highest AS highest,
      CAST(
        SUM(part.readings) OVER (
          PARTITION BY named.channel_id
          ORDER BY part.slice_no
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) - part.readings AS samples_before,
      CAST(FLOOR(given.fraction * CAST(named.readings AS DOUBLE)) AS BIGINT) AS quota,
      CASE
        WHEN given.duration IS NOT NULL
          THEN MIN(part.earliest) OVER (PARTITION BY named.channel_id) + given.duration
        ELSE given.declared_end
      END AS calibration_end
    FROM slices AS part
    JOIN channels AS named ON named.asset = part.asset AND named.channel = part.channel
    JOIN rules AS given ON given.calibration_no = named.calibration_no
    WHERE part.readings > 0
  ) AS ranked
) AS reached
