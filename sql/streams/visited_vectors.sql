-- Visited vectors: how many calibration vectors the visits of each channel add up to, and whether one of them shows
-- that its channel is not in order. For DuckDB, where vectors follow the order of rows. Proof: it is the one of
-- streams/visits.sql and rounds/visits.sql.
-- Reads:  visits
-- A row:  one channel that calibration teaches.
SELECT
  channel_id,
  CAST(SUM(visit.visits) AS BIGINT) AS vectors,
  MAX(visit.doubled) AS doubled
FROM visits AS visit
GROUP BY channel_id
