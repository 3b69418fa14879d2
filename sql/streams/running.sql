-- Running, of one channel, in stored order: as health/running.sql. For DuckDB, which counts novel ones on along the rows
-- as they come. Proof: that of streams/scored_vectors.sql, of the same rows.
-- Reads:  scored_vectors
-- A row:  one scored vector; straddling = 1 if it reaches back into calibration.
-- Slots:  :outside       whether a coordinate lies outside the calibrated range
--         :span          (m-1) * tau, the samples between its oldest and its newest
--         :context_rows  samples that are read before the first one after calibration
SELECT
  channel_id,
  time,
  cell_key,
  :outside AS out_of_range,
  CASE WHEN position - :span <= :context_rows THEN 1 ELSE 0 END AS straddling,
  novel,
  number,
  CAST(SUM(novel) OVER (ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW) AS BIGINT) AS novel_so_far
FROM scored_vectors
WHERE number > 0
