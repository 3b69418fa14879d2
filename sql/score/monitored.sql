-- Monitored: the vectors to be scored (method, section 4). Of channels without a missing sample that are read from
-- their run-up on, they are all; else which they are is said by counted and untaught.
-- Reads:  vectors, bounds
-- A row:  one vector.
-- Slots:  :carried  columns that travel with the vector
--         :counted  whether it is to be scored
SELECT
  vector.channel_id AS channel_id,
  scale.support_id AS support_id,
  vector.time AS time,
  vector.cell_key AS cell_key,
  vector.out_of_range AS out_of_range,
  vector.position AS position,
  vector.context_time AS context_time,
  :carried
FROM vectors AS vector
JOIN bounds AS scale ON scale.channel_id = vector.channel_id
WHERE :counted
