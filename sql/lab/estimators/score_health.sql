-- Score health: HI(t) = (1 / W) * sum of the scores of the last W scored vectors (Eq. 2), NULL until there
-- are W of them. The only division, and the last step.
-- Reads:  moving_sums, channels
-- A row:  one scored vector, in order.
-- Slots:  :time  the instant as the source tells time
SELECT
  named.asset AS asset,
  named.channel AS channel,
  :time AS time,
  counted.score AS score,
  CASE
    WHEN counted.number >= counted.window_length
      THEN CAST(counted.units_in_window AS DOUBLE)
        / (CAST(1048576 AS DOUBLE) * CAST(counted.window_length AS DOUBLE))
  END AS hi
FROM moving_sums AS counted
JOIN channels AS named ON named.channel_id = counted.channel_id
ORDER BY named.asset, named.channel, counted.time
