-- Window lengths: how many vectors the indicator is a share of, where the window is full.
-- Reads:  raw_indicator
-- A row:  one length.
SELECT DISTINCT vectors_in_window
FROM raw_indicator
WHERE hi IS NOT NULL AND vectors_in_window > 0
