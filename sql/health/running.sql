-- Running: the scored vectors of a channel, whose numbers are known, with the novel ones counted on; as numbered. Every
-- sample before the first of them is one of calibration.
-- Reads:  vectors, run_up
-- A row:  one scored vector; straddling = 1 if it reaches back into calibration.
-- Slots:  :span          (m-1) * tau, the samples between its oldest and its newest
--         :novel_so_far  the expression of health/novel_so_far.sql, or a column that holds it
SELECT
  vector.channel_id AS channel_id,
  vector.time AS time,
  vector.cell_key AS cell_key,
  vector.out_of_range AS out_of_range,
  CASE WHEN vector.position - :span <= reached.context_rows THEN 1 ELSE 0 END AS straddling,
  vector.novel AS novel,
  vector.number AS number,
  :novel_so_far AS novel_so_far
FROM vectors AS vector
JOIN run_up AS reached ON reached.channel_id = vector.channel_id
