-- Teachable: the vectors of one delay, as learnable has them. Repeated by Python, once per delay.
-- Reads:  sampled, learners
-- A row:  one vector of a learner, which is a channel under a delay; time is the place of its newest held.
-- Slots:  :delay_no  the number of the delay
--         :delayed   code_1 ... code_(m-1) and the piece of the oldest sample, over the same order
--         :inside    no sample is missing or lies outside the range
--         :cell_key  the mixed-radix integer of the coordinates
SELECT channel_id, time, CAST(:cell_key AS BIGINT) AS cell_key
FROM (
  SELECT channel_id, time, piece, code AS code_0, :delayed
  FROM (
    SELECT
      learner.learner_id AS channel_id,
      held.place AS time,
      held.piece AS piece,
      held.code AS code
    FROM sampled AS held
    JOIN learners AS learner ON learner.channel_id = held.channel_id
    WHERE learner.delay_no = :delay_no
  ) AS plain
) AS embedded
WHERE oldest_piece = piece AND :inside
