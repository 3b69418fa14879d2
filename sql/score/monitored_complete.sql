-- Monitored, complete channels: the short form where no sample is missing. Every vector from the first
-- scored one on counts, so its number is its position less the samples before.
-- Reads:  vectors, bounds, run_up
-- A row:  one vector, with its number.
-- Slots:  :span  (m-1) * tau, the samples before the first vector
SELECT
  vector.channel_id AS channel_id,
  scale.support_id AS support_id,
  vector.time AS time,
  vector.cell_key AS cell_key,
  vector.out_of_range AS out_of_range,
  vector.position
  - CASE WHEN before.samples_before > :span THEN before.samples_before ELSE :span END AS number
FROM vectors AS vector
JOIN bounds AS scale ON scale.channel_id = vector.channel_id
JOIN run_up AS before ON before.channel_id = vector.channel_id
WHERE vector.time >= scale.first_scored AND scale.lo IS NOT NULL
