-- Bands: where calibration was, by the newest coordinate, and how much of that no block farther than g away vouches for:
-- what alarms/buffered.sql counts by blocks (alarms, section 5).
-- Reads:  vouched
-- A row:  one band of one channel that calibration visited.
-- Slots:  :g  how far away a block must be to vouch for a cell
SELECT
  channel_id,
  CAST(:g AS BIGINT) AS g,
  band,
  CAST(SUM(part.visits) AS BIGINT) AS visits,
  CAST(SUM(CASE WHEN part.reach <= :g THEN part.visits ELSE 0 END) AS BIGINT) AS novel_buffered
FROM vouched AS part
GROUP BY channel_id, band
