-- Raised by limit: each value of the indicator, and whether it is above the limit of its channel.
-- Reads:  indicator, channel_limits
-- A row:  one value; a channel without a limit is never raised.
-- Slots:  :limit  a limit for all channels, or NULL
SELECT
  asset,
  channel,
  time,
  CASE WHEN hi > COALESCE(CAST(:limit AS DOUBLE), channel_limit, hi_limit) THEN 1 ELSE 0 END AS is_raised
FROM (
  SELECT
    measured.asset AS asset,
    measured.channel AS channel,
    measured.time AS time,
    measured.hi AS hi,
    measured.hi_limit AS hi_limit,
    CASE WHEN limited.hit = 1 THEN limited.hi_limit END AS channel_limit
  FROM indicator AS measured
  LEFT JOIN (SELECT asset, channel, hi_limit, 1 AS hit FROM channel_limits) AS limited
    ON limited.asset = measured.asset AND limited.channel = measured.channel
  WHERE measured.hi IS NOT NULL
) AS beside
