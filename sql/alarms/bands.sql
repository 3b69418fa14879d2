-- Bands: where calibration was, by the newest coordinate, and how much of that no block farther than g away vouches for:
-- what alarms/buffered.sql counts by blocks (alarms, section 5).
-- Reads:  banded, vouched
-- A row:  one band of one channel that calibration visited.
-- Slots:  :g  how far away a block must be to vouch for a cell
SELECT
  whole.channel_id AS channel_id,
  CAST(:g AS BIGINT) AS g,
  whole.band AS band,
  whole.visits AS visits,
  CASE WHEN near.hit = 1 THEN near.visits ELSE 0 END AS novel_buffered
FROM banded AS whole
LEFT JOIN (
  SELECT channel_id, band, CAST(SUM(part.visits) AS BIGINT) AS visits, 1 AS hit
  FROM vouched AS part
  WHERE reach <= :g
  GROUP BY channel_id, band
) AS near ON near.channel_id = whole.channel_id AND near.band = whole.band
