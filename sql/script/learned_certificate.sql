-- Learned certificate: each block, judged by what the others have learnt, and what those up to it know.
-- Reads:  blocks, learning
-- Slots:  :first_time  as the source has it
--         :last_time   likewise
SELECT
  counted.asset AS asset,
  counted.channel AS channel,
  counted.block AS block,
  :first_time AS first_time,
  :last_time AS last_time,
  counted.vectors AS vectors,
  counted.novel AS novel,
  counted.healthy_hi AS healthy_hi,
  curve.learned_vectors AS learned_vectors,
  curve.learned_cells AS learned_cells,
  curve.learned_floor AS learned_floor
FROM blocks AS counted
JOIN learning AS curve
  ON curve.asset = counted.asset AND curve.channel = counted.channel AND curve.pool_block = counted.block
WHERE counted.level = 0
