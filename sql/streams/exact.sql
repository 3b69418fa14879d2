-- Exact: whether the range of one channel, written as text, is the one that was calibrated, to the last bit.
-- Reads:  bounds
-- A row:  the channel.
-- Slots:  :channel_id, :lo, :hi
SELECT CASE WHEN scale.calibrated_lo = :lo AND scale.calibrated_hi = :hi THEN 1 ELSE 0 END AS is_exact
FROM bounds AS scale
WHERE scale.channel_id = :channel_id
