-- Limits: the limit of each channel's indicator. A calibration that is no fair sample of what follows
-- judges nothing, so its channel has none.
-- Reads:  limits, the relation that holds them.
-- A row:  one row of it.
-- Slots:  :asset, :channel  the names, as text
--         :hi_limit         the limit; NULL where the channel has none
--         :limit_reason     why judgements have no limit; NULL where the table does not tell
SELECT
  CAST(:asset AS VARCHAR) AS asset,
  CAST(:channel AS VARCHAR) AS channel,
  CASE
    WHEN COALESCE(:limit_reason, '') <> 'unrepresentative' THEN CAST(:hi_limit AS DOUBLE)
  END AS hi_limit
FROM limits
