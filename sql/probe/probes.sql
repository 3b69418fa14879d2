-- Probes: what the indicator would show of each channel if its machine changed, as two integers.
-- Reads:  channels, probe
-- A row:  one change of one channel, in order; what speaks of the support is the pool's.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  asked.change_name AS change_name,
  asked.vectors AS vectors,
  asked.novel AS novel
FROM channels AS named
JOIN probe AS asked ON asked.support_id = named.support_id
ORDER BY named.asset, named.channel, asked.change_no
