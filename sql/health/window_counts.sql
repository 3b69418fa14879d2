-- Window counts: the two integers of Eq. 2, kept apart until the very end. The count over the last
-- window vectors is the difference of two running counts, never a frame of window rows.
-- Reads:  numbered
-- A row:  one scored vector.
-- Slots:  :window        W, in vectors
--         :novel_before  novel_so_far of the vector W before
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
    :novel_before AS novel_before
  FROM numbered
) AS lagged
