-- Health indicator: HI(t) = (1 / W) * sum of a over the last W scored vectors (Eq. 2), NULL until
-- there are W of them. The only division, and the last step.
-- Reads:  window_counts, channels
-- A row:  one scored vector, in order: channels are numbered as their names go.
-- Slots:  :time  the instant as the source tells time
SELECT
  named.asset AS asset,
  named.channel AS channel,
  :time AS time,
  counted.cell_key AS cell_key,
  CAST(counted.novel AS BIGINT) AS novel,
  CAST(counted.out_of_range AS BIGINT) AS out_of_range,
  CAST(counted.straddling AS BIGINT) AS straddling,
  CAST(counted.novel_in_window AS BIGINT) AS novel_in_window,
  CAST(counted.vectors_in_window AS BIGINT) AS vectors_in_window,
  CASE
    WHEN counted.vectors_in_window = counted.window_length
      THEN CAST(counted.novel_in_window AS DOUBLE) / CAST(counted.window_length AS DOUBLE)
  END AS hi
FROM window_counts AS counted
JOIN channels AS named ON named.channel_id = counted.channel_id
ORDER BY counted.channel_id, counted.time
