-- Health indicator: the share of novel vectors among the last W scored ones (Eq. 2).
-- Reads:  window_counts
-- Slots:  :time  as the source has it
SELECT
  counted.asset AS asset,
  counted.channel AS channel,
  :time AS time,
  counted.cell_key AS cell_key,
  counted.novel AS novel,
  counted.out_of_range AS out_of_range,
  counted.straddling AS straddling,
  counted.novel_in_window AS novel_in_window,
  counted.vectors_in_window AS vectors_in_window,
  CASE
    WHEN counted.vectors_in_window = counted.window_length
      THEN CAST(counted.novel_in_window AS DOUBLE) / CAST(counted.window_length AS DOUBLE)
  END AS hi
FROM window_counts AS counted
