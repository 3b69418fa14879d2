-- Buffered: u_b, the vectors of a block whose cell no block farther than g away has visited (alarms, section 2).
-- Reads:  vouched
-- A row:  one block of one channel.
-- Slots:  :g  how far away a block must be to vouch for a cell
SELECT
  channel_id,
  CAST(:g AS BIGINT) AS g,
  block,
  vectors,
  CAST(SUM(CASE WHEN part.reach <= :g THEN part.visits ELSE 0 END) AS BIGINT) AS novel_buffered
FROM vouched AS part
GROUP BY channel_id, block, vectors
