-- Probed: the picked vectors of one delay with the values that they would hold at other speeds; as probe/probed.sql.
-- Repeated by Python, once per delay.
-- Reads:  sampled, learners, taught_passing, picked
-- A row:  one picked vector; of each pace the farthest value is NULL where it is not in the piece of the newest held.
-- Slots:  :delay_no  the number of the delay
--         :delayed   values and pieces so many samples before
--         :reached   x_(pace)_k, the values of each pace, each where it counts
SELECT
  vector.support_id AS support_id,
  vector.number AS number,
  vector.block AS block,
  delay_vector.x_0 AS x_0,
  :reached
FROM (
  SELECT channel_id, time, piece, value AS x_0, :delayed
  FROM (
    SELECT
      learner.learner_id AS channel_id,
      held.place AS time,
      held.piece AS piece,
      held.value AS value
    FROM sampled AS held
    JOIN learners AS learner ON learner.channel_id = held.channel_id
    JOIN taught_passing AS teacher ON teacher.channel_id = learner.learner_id
    WHERE learner.delay_no = :delay_no
  ) AS plain
) AS delay_vector
JOIN picked AS vector ON vector.channel_id = delay_vector.channel_id AND vector.time = delay_vector.time
