-- Stillness of one channel, in stored order: since when it stands still at its end; as stored/scoring/stillness.sql.
-- For DuckDB, over embedding/moving_codes.sql along the rows as stored. Proof: that of the vectors (streams/vectors.sql),
-- of the same rows.
-- Reads:  moving_codes, the samples of the channel from its run-up on
-- A row:  the channel; still_since is NULL where the newest sample does not stand still.
-- Slots:  :channel_id, :first_scored
--         :long_ago  an instant before all others
SELECT
  CAST(:channel_id AS INTEGER) AS channel_id,
  MIN(CASE WHEN time > last_moving AND time >= :first_scored THEN time END) AS still_since
FROM (
  SELECT
    time,
    MAX(CASE WHEN still = 0 THEN time ELSE CAST(:long_ago AS BIGINT) END) OVER () AS last_moving
  FROM moving_codes
) AS movement
