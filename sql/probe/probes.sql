-- Probes: what the indicator would show of each channel if its machine changed, as two integers.
-- Reads:  channels, probe
-- A row:  one change of one channel, in order; what speaks of the support is the pool's.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  outcome.change_name AS change_name,
  outcome.vectors AS vectors,
  outcome.novel AS novel
FROM channels AS named
JOIN probe AS outcome ON outcome.support_id = named.support_id
ORDER BY named.asset, named.channel, outcome.change_no
