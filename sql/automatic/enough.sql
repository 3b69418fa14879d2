-- Enough: the delays under which a support has vectors enough to tell, and not much fewer than at the usual delay.
-- Reads:  block_sizes, learners, usual_vectors
-- A row:  one support.
-- Slots:  :least_vectors  calibration vectors below which a floor promises nothing
SELECT held.support_id AS support_id
FROM (
  SELECT support_id, CAST(SUM(size.vectors) AS BIGINT) AS vectors
  FROM block_sizes AS size
  GROUP BY support_id
) AS held
JOIN (
  SELECT DISTINCT support_id, unit_id
  FROM learners
) AS learner ON learner.support_id = held.support_id
JOIN usual_vectors AS usual ON usual.unit_id = learner.unit_id
WHERE held.vectors >= :least_vectors AND 10 * held.vectors >= 9 * usual.vectors
