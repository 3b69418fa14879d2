-- Marked vectors: v(t) = [x(t), x(t - tau), ..., x(t - (m-1) tau)] (Eq. 1) in codes, as the key of
-- its cell, inside one segment, with its relation to calibration (method, section 4).
-- Reads:  marked_codes
-- A row:  one vector, at the time of its newest sample; cell_key is NULL where a sample is missing.
--         calibration_vector = 1 if every sample from its oldest to its newest is one of calibration,
--         straddling = 1 if at least one of its m samples is. position and context_time as in vectors.
-- Slots:  :delayed   code_1 ... code_(m-1) and calibrating_1 ..., the delayed columns
--         :carried   columns that travel with the vector
--         :span      (m-1) * tau, the samples between oldest and newest
--         :context   the time of the oldest sample of the next vector
--         :known     all coordinates are there
--         :cell_key  the mixed-radix integer of the coordinates
--         :outside   a coordinate lies outside the calibrated range
--         :touching  one of the samples is one of calibration
--         :long_ago  an instant before all others
SELECT
  channel_id,
  time,
  CASE WHEN :known THEN :cell_key END AS cell_key,
  CASE WHEN :outside THEN 1 ELSE 0 END AS out_of_range,
  CASE WHEN :touching THEN 1 ELSE 0 END AS straddling,
  CASE WHEN oldest_time > last_uncalibrated THEN 1 ELSE 0 END AS calibration_vector,
  position,
  context_time,
  :carried
FROM (
  SELECT
    channel_id,
    time,
    code AS code_0,
    calibrating AS calibrating_0,
    :delayed,
    LAG(time, :span) OVER (PARTITION BY channel_id ORDER BY time) AS oldest_time,
    MAX(CASE WHEN breaking = 1 THEN time ELSE CAST(:long_ago AS BIGINT) END) OVER (
      PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS segment_from,
    MAX(CASE WHEN calibrating = 0 THEN time ELSE CAST(:long_ago AS BIGINT) END) OVER (
      PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS last_uncalibrated,
    :context AS context_time,
    CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) AS position
  FROM marked_codes
) AS embedded
WHERE position > :span AND oldest_time >= segment_from
