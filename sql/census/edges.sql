-- Edges: the slices of each channel in order, and which of them must be read sample by sample: those that may
-- hold one of the last samples of calibration, or of the last ones before scoring, and those in which a part of
-- calibration begins or ends (method, section 4). All others lie within calibration or outside of it.
-- Reads:  slices, channels, rules, cuts
-- A row:  one slice of one channel; is_edge = 1 if it must be read. quota is the number of its calibration
--         samples where that is a fraction.
-- Slots:  :reach  samples up to the last one before scoring that are asked for, at least 1
SELECT
  reached.channel_id AS channel_id,
  reached.first_time AS first_time,
  reached.last_time AS last_time,
  reached.samples AS samples,
  reached.lowest AS lowest,
  reached.highest AS highest,
  reached.samples_before AS samples_before,
  reached.quota AS quota,
  CASE
    WHEN cut.hit = 1 THEN 1
    WHEN reached.first_time <= reached.calibration_end
      AND reached.last_time > reached.calibration_end THEN 1
    WHEN reached.samples_before < reached.quota
      AND reached.samples_before + reached.samples > reached.quota - :reach THEN 1
    WHEN reached.first_time <= reached.unscored_end
      AND reached.samples_before + reached.samples > reached.samples_inside - :reach THEN 1
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
    COALESCE(score_from - 1, calibration_end) AS unscored_end,
    CAST(
      SUM(CASE WHEN last_time <= COALESCE(score_from - 1, calibration_end) THEN samples ELSE 0 END) OVER (
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
          ORDER BY part.earliest
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) - part.readings AS samples_before,
      CAST(FLOOR(chosen_rule.fraction * CAST(named.readings AS DOUBLE)) AS BIGINT) AS quota,
      CASE
        WHEN chosen_rule.duration IS NOT NULL
          THEN MIN(part.earliest) OVER (PARTITION BY named.channel_id) + chosen_rule.duration
        ELSE chosen_rule.declared_end
      END AS calibration_end,
      chosen_rule.score_from AS score_from
    FROM slices AS part
    JOIN channels AS named ON named.asset = part.asset AND named.channel = part.channel
    JOIN rules AS chosen_rule ON chosen_rule.calibration_no = named.calibration_no
    WHERE part.readings > 0
  ) AS ranked
) AS reached
LEFT JOIN (
  SELECT channel_id, first_time, 1 AS hit
  FROM cuts
) AS cut ON cut.channel_id = reached.channel_id AND cut.first_time = reached.first_time
