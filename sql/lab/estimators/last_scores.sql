-- Last scores: where each channel stands: its indicator at the last scored vector.
-- Reads:  channels, moving_sums
-- A row:  one channel, in order; last_time and hi are NULL where nothing was scored, hi also where less
--         than a window was.
-- Slots:  :time  the instant as the source tells time
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(CASE WHEN latest.hit = 1 THEN latest.number ELSE 0 END AS BIGINT) AS scored_vectors,
  CASE WHEN latest.hit = 1 THEN :time END AS last_time,
  CASE
    WHEN latest.hit = 1 AND latest.number >= latest.window_length
      THEN CAST(latest.units_in_window AS DOUBLE)
        / (CAST(1048576 AS DOUBLE) * CAST(latest.window_length AS DOUBLE))
  END AS hi
FROM channels AS named
LEFT JOIN (
  SELECT
    counted.channel_id AS channel_id,
    counted.time AS time,
    counted.number AS number,
    counted.units_in_window AS units_in_window,
    counted.window_length AS window_length,
    1 AS hit
  FROM moving_sums AS counted
  JOIN (
    SELECT channel_id, MAX(number) AS last_number
    FROM moving_sums
    GROUP BY channel_id
  ) AS ended ON ended.channel_id = counted.channel_id AND ended.last_number = counted.number
) AS latest ON latest.channel_id = named.channel_id
ORDER BY named.asset, named.channel
