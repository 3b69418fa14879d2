-- Health: the share of novel vectors among the last W (Eq. 2), and whether it is above its limit.
-- Reads:  health_indicator, support_summary
-- Slots:  :columns  those of the verdicts
SELECT
  learnt.asset AS asset,
  :columns,
  learnt.verdict AS verdict,
  learnt.hi_limit AS hi_limit,
  CASE WHEN vector.hi > learnt.hi_limit THEN 1 WHEN vector.hi <= learnt.hi_limit THEN 0 END AS is_above
FROM health_indicator AS vector
JOIN support_summary AS learnt ON learnt.asset = vector.asset AND learnt.channel = vector.channel
