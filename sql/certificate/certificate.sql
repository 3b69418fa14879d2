-- Certificate: each block of calibration with its two integers, and the learning curve up to it.
-- Reads:  channels, blocks, learning
-- A row:  one block of one channel.
-- Slots:  :first_time, :last_time  the instants of its first and last vector as the source tells time
SELECT
  named.asset AS asset,
  named.channel AS channel,
  counted.block AS block,
  :first_time AS first_time,
  :last_time AS last_time,
  CAST(counted.vectors AS BIGINT) AS vectors,
  CAST(counted.novel AS BIGINT) AS novel,
  counted.healthy_hi AS healthy_hi,
  CAST(curve.learned_vectors AS BIGINT) AS learned_vectors,
  CAST(curve.learned_cells AS BIGINT) AS learned_cells,
  curve.learned_floor AS learned_floor
FROM blocks AS counted
JOIN channels AS named ON named.channel_id = counted.channel_id
JOIN learning AS curve
  ON curve.support_id = counted.support_id AND curve.pool_block = counted.pool_block
ORDER BY named.asset, named.channel, counted.block
