-- Learnt: the vectors of a learner in order, cut into blocks; as certificate/learnt.sql, where windows differ.
-- Reads:  teachable, learners
-- A row:  one vector; place numbers those of its learner from 0, block is learner and block_no as one number. part is
--         what is left out to judge a grid: the block, or the whole machine where members of the pool taught nothing.
-- Slots:  :block_no  the expression of certificate/block_no.sql, of place, vectors and window_length
SELECT
  channel_id,
  support_id,
  time,
  cell_key,
  place,
  block_no,
  CAST(channel_id AS BIGINT) * CAST(2147483648 AS BIGINT) + block_no AS block,
  CAST(channel_id AS BIGINT) * CAST(2147483648 AS BIGINT) + CASE WHEN by_machine = 1 THEN 0 ELSE block_no END AS part
FROM (
  SELECT channel_id, support_id, by_machine, time, cell_key, place, CAST(:block_no AS BIGINT) AS block_no
  FROM (
    SELECT
      vector.channel_id AS channel_id,
      learner.support_id AS support_id,
      learner.window_length AS window_length,
      learner.by_machine AS by_machine,
      vector.time AS time,
      vector.cell_key AS cell_key,
      CAST(
        ROW_NUMBER() OVER (PARTITION BY vector.channel_id ORDER BY vector.time) AS BIGINT
      ) - 1 AS place,
      CAST(COUNT(*) OVER (PARTITION BY vector.channel_id) AS BIGINT) AS vectors
    FROM teachable AS vector
    JOIN learners AS learner ON learner.learner_id = vector.channel_id
  ) AS ordered
) AS parted
