-- Series of one channel, in stored order: its samples in figures, the instant of its quota-th sample, and from where on
-- it is read so that the next one finds its oldest sample. For DuckDB, which reads up to that row and sorts nothing.
-- Proof: as many samples must lie up to the one, and from the other on (streams/calibrated.sql).
-- Reads:  readings
-- A row:  the channel; the instants are NULL where no sample is asked for.
-- Slots:  :asset, :channel
--         :samples       it has
--         :first_time    the instant of the first of them
--         :before        samples before those that are asked for
--         :sample_count  how many these are: up to the quota-th
SELECT
  CAST(:samples AS BIGINT) AS samples,
  CAST(0 AS BIGINT) AS conflicts,
  CAST(:first_time AS BIGINT) AS first_time,
  reached.quota_time AS quota_time,
  reached.read_from AS read_from
FROM (
  SELECT MAX(page.time) AS quota_time, MIN(page.time) AS read_from
  FROM (
    SELECT time
    FROM readings
    WHERE asset = :asset AND channel = :channel
    LIMIT :sample_count
    OFFSET :before
  ) AS page
) AS reached
