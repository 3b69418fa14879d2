-- Levels: the ladder of coarser grids, bin div 2^k (method, section 5). Repeated by Python, once per
-- level; level 0 is the grid itself.
-- Slots:  :level, :divisor  k and 2^k
--         :level_bins       ceil(bins / 2^k), at least 2 for k > 0
SELECT
  CAST(:level AS INTEGER) AS level,
  CAST(:divisor AS DOUBLE) AS divisor,
  :level_bins AS level_bins
