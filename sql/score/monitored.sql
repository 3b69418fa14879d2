-- Monitored: the vectors to be scored (method, section 4): newest sample after calibration (or from
-- score_from on), no sample missing, not a calibration vector.
-- Reads:  marked_vectors, bounds
-- A row:  one vector.
-- Slots:  :carried  columns that travel with the vector
SELECT
  vector.channel_id AS channel_id,
  scale.support_id AS support_id,
  vector.time AS time,
  vector.cell_key AS cell_key,
  vector.out_of_range AS out_of_range,
  vector.straddling AS straddling,
  vector.position AS position,
  vector.context_time AS context_time,
  :carried
FROM marked_vectors AS vector
JOIN bounds AS scale ON scale.channel_id = vector.channel_id
WHERE vector.time >= scale.first_scored
  AND vector.calibration_vector = 0
  AND vector.cell_key IS NOT NULL
  AND scale.calibrated_lo IS NOT NULL
