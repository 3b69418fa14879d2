-- Exact: whether the range of one channel, written as text, is the one that was calibrated, to the last bit. For
-- DuckDB, which is given ranges as literals (streams/vectors.sql). Proof: it is one itself; where it is 0, all is
-- done again by embedding/vectors.sql.
-- Reads:  bounds
-- A row:  the channel; 0 where it has no range.
-- Slots:  :channel_id, :lo, :hi
SELECT
  COALESCE(
    MIN(CASE WHEN scale.calibrated_lo = :lo AND scale.calibrated_hi = :hi THEN 1 ELSE 0 END), 0
  ) AS is_exact
FROM bounds AS scale
WHERE scale.channel_id = :channel_id
