-- Reread: scored vectors that are read again, with the samples that each is made of.
-- Reads:  scored_vectors, samples
-- A row:  one vector that has a cell; its window is numbered as in banded.
-- Slots:  :window   W, in vectors
--         :delayed  x_1, x_2, ... the samples before the newest one, x_0, and the number of the program
--         :carried  the same columns
SELECT
  visit.channel_id AS channel_id,
  CAST(
    FLOOR((CAST(visit.number AS DOUBLE) - CAST(5e-1 AS DOUBLE)) / CAST(:window AS DOUBLE)) AS BIGINT
  ) AS window_no,
  visit.novel AS novel,
  newest.x_0 AS x_0,
  :carried
FROM scored_vectors AS visit
JOIN (
  SELECT channel_id, time, value AS x_0, :delayed
  FROM samples
) AS newest ON newest.channel_id = visit.channel_id AND newest.time = visit.time
WHERE visit.cell_key IS NOT NULL
