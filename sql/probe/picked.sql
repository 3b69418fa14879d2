-- Picked: the calibration vectors by which a support is probed: all of them below 1,000, else 500 to 1,000, spread by a
-- multiplication of their numbers. They are numbered from 0 over all members of a pool.
-- Reads:  learnt, block_sizes, taught_before
-- A row:  one vector.
-- Slots:  :picked  the expression of probe/is_picked.sql
SELECT support_id, channel_id, time, block, number
FROM (
  SELECT
    vector.support_id AS support_id,
    vector.channel_id AS channel_id,
    vector.time AS time,
    size.pool_block AS block,
    teacher.vectors_before + vector.place AS number,
    teacher.vectors AS vectors
  FROM learnt AS vector
  JOIN block_sizes AS size ON size.channel_id = vector.channel_id AND size.block_no = vector.block_no
  JOIN taught_before AS teacher ON teacher.channel_id = vector.channel_id
) AS numbered
WHERE :picked
