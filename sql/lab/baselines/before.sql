-- Before: each point with the one a sample earlier, from which a forecast of x_0 is made.
-- Reads:  coordinates
-- A row:  one sample; elapsed is the step in time to the sample before it.
-- Slots:  :point    x_0 ... x_(m-1)
--         :earlier  before_0 ... before_(m-1), the same a sample earlier
SELECT
  channel_id,
  time,
  :point,
  :earlier,
  time - LAG(time, 1) OVER (PARTITION BY channel_id ORDER BY time) AS elapsed
FROM coordinates AS point
