-- Monitored, complete channels: the short form where no sample is missing. Every vector read counts,
-- so its number is its position less the samples of the run-up.
-- Reads:  vectors, bounds
-- A row:  one vector, with its number.
-- Slots:  :span     (m-1) * tau, the samples before the first vector
--         :carried  columns that travel with the vector
SELECT
  vector.channel_id AS channel_id,
  scale.support_id AS support_id,
  vector.time AS time,
  vector.cell_key AS cell_key,
  vector.out_of_range AS out_of_range,
  vector.position - :span AS number,
  vector.position AS position,
  vector.context_time AS context_time,
  :carried
FROM vectors AS vector
JOIN bounds AS scale ON scale.channel_id = vector.channel_id
