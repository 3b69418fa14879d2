-- Lagged: each sample beside those some samples before it in the same run. Where there is none the level
-- is NULL or 0, by engine, and so never above 0: no pair.
-- Reads:  selected
-- A row:  one sample.
-- Slots:  :levels  the level some lags ago, a column for each lag
SELECT channel_id, level AS level_0, :levels
FROM selected
