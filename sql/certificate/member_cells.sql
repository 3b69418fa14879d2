-- Member cells: the cells of a pool, with which member visited each first and last.
-- Reads:  cells, member_sizes
-- A row:  one cell of one support.
SELECT
  seen.support_id AS support_id,
  seen.cell_key AS cell_key,
  seen.visits AS visits,
  opening.pool_block AS first_block,
  closing.pool_block AS last_block
FROM cells AS seen
JOIN member_sizes AS opening ON opening.channel_id = seen.first_channel
JOIN member_sizes AS closing ON closing.channel_id = seen.last_channel
