-- Raised machines: the values of each channel, and those of its machine, which is raised while at least
-- one of its channels is. A channel stays as its last value left it.
-- Reads:  raised
-- A row:  one value of one channel, or, with channel NULL, one instant of one machine.
SELECT asset, channel, time, is_raised
FROM raised
UNION ALL
SELECT
  asset,
  CAST(NULL AS VARCHAR) AS channel,
  time,
  CASE WHEN channels_raised > 0 THEN 1 ELSE 0 END AS is_raised
FROM (
  SELECT
    asset,
    time,
    SUM(channels_more) OVER (PARTITION BY asset ORDER BY time ROWS UNBOUNDED PRECEDING) AS channels_raised
  FROM (
    SELECT
      asset,
      time,
      SUM(is_raised - CASE WHEN value_no > 1 THEN raised_before ELSE 0 END) AS channels_more
    FROM (
      SELECT
        asset,
        channel,
        time,
        is_raised,
        LAG(is_raised, 1) OVER (PARTITION BY asset, channel ORDER BY time) AS raised_before,
        CAST(ROW_NUMBER() OVER (PARTITION BY asset, channel ORDER BY time) AS BIGINT) AS value_no
      FROM raised
    ) AS lagged
    GROUP BY asset, time
  ) AS changes
) AS machines
