-- Raised machines: the values of each channel, and those of its machine, which is raised while at least
-- one of its channels is. A channel stays as its last value left it.
-- Reads:  raised
-- A row:  one value of one channel, or, with channel NULL, one instant of one machine.
SELECT asset, channel, time, is_raised
FROM raised
UNION ALL
SELECT
  asset,
  NULL AS channel,
  time,
  CASE WHEN channels_raised > 0 THEN 1 ELSE 0 END AS is_raised
FROM (
  SELECT
    asset,
    time,
    SUM(SUM(change)) OVER (PARTITION BY asset ORDER BY time) AS channels_raised
  FROM (
    SELECT
      asset,
      time,
      is_raised - COALESCE(
        LAG(is_raised, 1) OVER (PARTITION BY asset, channel ORDER BY time),
        0
      ) AS change
    FROM raised
  ) AS changes
  GROUP BY asset, time
) AS machines
