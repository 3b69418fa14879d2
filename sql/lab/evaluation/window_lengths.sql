-- Window lengths: how many vectors the indicator is a share of, where the window is full.
-- Reads:  given
-- A row:  one length.
SELECT DISTINCT vectors_in_window
FROM given
WHERE hi IS NOT NULL AND vectors_in_window > 0
