-- Taught passing: as taught_before, of supports that pass on some grid: no others are probed. Of siblings that are
-- many fewer vectors each are picked: the vectors count so many times.
-- Reads:  taught_before, passing, learners
-- A row:  one learner.
SELECT
  teacher.channel_id AS channel_id,
  teacher.vectors * learner.thinning AS vectors,
  teacher.vectors_before AS vectors_before
FROM taught_before AS teacher
JOIN learners AS learner ON learner.learner_id = teacher.channel_id
JOIN (
  SELECT DISTINCT support_id
  FROM passing
) AS good ON good.support_id = teacher.support_id
