-- Raised by limit: each value of the indicator, and whether it is above the limit of its channel.
-- Reads:  indicator, channel_limits
-- A row:  one value; a channel without a limit is never raised.
-- Slots:  :limit  a limit for all channels, or NULL
SELECT
  measured.asset AS asset,
  measured.channel AS channel,
  measured.time AS time,
  CASE
    WHEN measured.hi > COALESCE(CAST(:limit AS DOUBLE), measured.hi_limit, limited.hi_limit) THEN 1
    ELSE 0
  END AS is_raised
FROM indicator AS measured
LEFT JOIN channel_limits AS limited
  ON limited.asset = measured.asset AND limited.channel = measured.channel
WHERE measured.hi IS NOT NULL
