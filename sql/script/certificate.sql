-- Certificate: each block, judged by what the others have learnt.
-- Reads:  blocks
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
  counted.healthy_hi AS healthy_hi
FROM blocks AS counted
WHERE counted.level = 0
