-- Window counts of one channel, in stored order: as health/window_counts.sql, from the scored vectors on. For DuckDB,
-- which counts novel ones on along the rows as they come. Proof: that of streams/placed.sql, of the same rows.
-- Reads:  placed
-- A row:  one scored vector; straddling = 1 if it reaches back into calibration.
-- Slots:  :outside       whether a coordinate lies outside the calibrated range
--         :span          (m-1) * tau, the samples between its oldest and its newest
--         :context_rows  samples that are read before the first one after calibration
--         :window        W, in vectors
SELECT
  channel_id,
  time,
  cell_key,
  novel,
  out_of_range,
  straddling,
  novel_so_far - CASE WHEN number > :window THEN novel_before ELSE 0 END AS novel_in_window,
  CASE WHEN number < :window THEN number ELSE :window END AS vectors_in_window,
  :window AS window_length
FROM (
  SELECT
    channel_id,
    time,
    cell_key,
    novel,
    out_of_range,
    straddling,
    number,
    novel_so_far,
    LAG(novel_so_far, :window) OVER () AS novel_before
  FROM (
    SELECT
      channel_id,
      time,
      cell_key,
      novel,
      :outside AS out_of_range,
      CASE WHEN position - :span <= :context_rows THEN 1 ELSE 0 END AS straddling,
      number,
      CAST(SUM(novel) OVER (ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW) AS BIGINT) AS novel_so_far
    FROM placed
    WHERE number > 0
  ) AS running
) AS lagged
