-- Dimensions: false nearest neighbours and Cao's quantities by dimension.
-- Reads:  false_neighbours, cao, ambiguous
-- A row:  one dimension of one channel; is_ambiguous = 1 where exact repetitions say that it is too small.
-- Slots:  :m_max  the largest dimension
SELECT
  fate.channel_id AS channel_id,
  fate.m AS m,
  fate.reference_vectors AS reference_vectors,
  fate.neighbours AS neighbours,
  fate.skipped AS skipped,
  fate.false_neighbours AS false_neighbours,
  CASE WHEN grown.hit = 1 THEN grown.e1 END AS e1,
  CASE WHEN grown.hit = 1 THEN grown.e2 END AS e2,
  CASE WHEN grown.hit = 1 THEN grown.e1_next END AS e1_next,
  CASE WHEN small.hit = 1 THEN 1 ELSE 0 END AS is_ambiguous
FROM false_neighbours AS fate
LEFT JOIN (
  SELECT channel_id, m, e1, e2, e1_next, 1 AS hit
  FROM cao
) AS grown ON grown.channel_id = fate.channel_id AND grown.m = fate.m
LEFT JOIN (
  SELECT channel_id, m, 1 AS hit
  FROM ambiguous
) AS small ON small.channel_id = fate.channel_id AND small.m = fate.m
WHERE fate.m <= :m_max
