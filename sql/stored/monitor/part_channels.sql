-- Part channels: the channels that one read of the source is for.
-- Reads:  wanted
-- A row:  one channel.
-- Slots:  :among  a condition on part: which of the two reads
SELECT
  part.channel_id AS channel_id,
  part.asset AS asset,
  part.channel AS channel,
  part.read_from AS read_from
FROM wanted AS part
WHERE :among
