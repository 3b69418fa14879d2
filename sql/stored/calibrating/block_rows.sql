-- Block rows: the certificate's two integers, block by block.
-- Reads:  blocks, numbering
-- A row:  one block of one new support, numbered over all members of its pool.
SELECT
  numbered.stored_support_id AS support_id,
  part.pool_block AS block,
  numbered.stored_channel_id AS channel_id,
  part.first_time AS first_time,
  part.last_time AS last_time,
  part.vectors AS vectors,
  part.novel AS novel
FROM blocks AS part
JOIN numbering AS numbered ON numbered.channel_id = part.channel_id
