-- Lags: how far back each channel is looked at: as far as mutual information goes, and at least as far as
-- each scale of the search for a cycle does.
-- Reads:  selected, extents
-- A row:  one lag of one channel, from 0; every lag is the place of some sample, less one.
-- Slots:  :least  lags of a scale
SELECT taken.channel_id AS channel_id, taken.place - 1 AS delay
FROM selected AS taken
JOIN extents AS extent ON extent.channel_id = taken.channel_id
WHERE taken.place - 1 <= extent.longest_lag OR taken.place - 1 <= :least
