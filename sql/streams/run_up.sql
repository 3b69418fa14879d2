-- Run-up of one channel: from where on it is read so that the first scored vector finds its oldest sample, if there
-- is one before it; as score/run_up.sql. For DuckDB, which keeps the few latest rows and leaves out most rows of
-- other channels where they lie apart. Proof: none is needed, whatever the order of rows.
-- Reads:  readings
-- A row:  the channel.
-- Slots:  :asset, :channel, :first_scored
--         :span     (m-1) * tau, the samples between oldest and newest
SELECT MIN(earlier.time) AS earliest, CAST(COUNT(*) AS BIGINT) AS context_rows
FROM (
  SELECT time
  FROM readings
  WHERE asset = :asset AND channel = :channel AND time < :first_scored
  ORDER BY time DESC
  LIMIT :span
) AS earlier
