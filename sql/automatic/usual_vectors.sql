-- Usual vectors: how many vectors a support has at the usual delay: another one must not lose many of them.
-- Reads:  sampled, learners
-- A row:  one support, whatever the delay.
-- Slots:  :delayed  code_1 ... code_(m-1) and the piece of the oldest sample, over the same order
--         :inside   no sample is missing or lies outside the range
SELECT unit_id, CAST(COUNT(*) AS BIGINT) AS vectors
FROM (
  SELECT unit_id, piece, code AS code_0, :delayed
  FROM (
    SELECT
      learner.channel_id AS channel_id,
      learner.unit_id AS unit_id,
      held.place AS time,
      held.piece AS piece,
      held.code AS code
    FROM sampled AS held
    JOIN (
      SELECT DISTINCT channel_id, unit_id
      FROM learners
    ) AS learner ON learner.channel_id = held.channel_id
  ) AS plain
) AS embedded
WHERE oldest_piece = piece AND :inside
GROUP BY unit_id
