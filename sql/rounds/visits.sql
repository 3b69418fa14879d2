-- Visits by rounds: how often each block of calibration visited each cell; as certificate/visits.sql. For DuckDB, by
-- rounds/vectors.sql: a vector's place in calibration is the number of its round, so that nothing is sorted. Proof:
-- all visits of a channel add up to its vectors, which block numbers are made of, and no row has doubled = 1
-- (streams/visited_vectors.sql).
-- Reads:  vectors
-- A row:  one cell in one block of one channel; doubled = 1 if a row of it is not where it should be.
-- Slots:  :span      (m-1) * tau, the samples between oldest and newest
--         :block_no  the expression of certificate/block_no.sql
SELECT
  channel_id,
  support_id,
  block_no,
  cell_key,
  CAST(COUNT(*) AS BIGINT) AS visits,
  MIN(learnt.time) AS first_time,
  MAX(learnt.time) AS last_time,
  MAX(learnt.doubled) AS doubled
FROM (
  SELECT channel_id, support_id, time, cell_key, doubled, :block_no AS block_no
  FROM (
    SELECT
      vector.channel_id AS channel_id,
      vector.support_id AS support_id,
      vector.time AS time,
      vector.cell_key AS cell_key,
      vector.doubled AS doubled,
      vector.position - :span - 1 AS place
    FROM vectors AS vector
  ) AS placed
) AS learnt
GROUP BY channel_id, support_id, block_no, cell_key
