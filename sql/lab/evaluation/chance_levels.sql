-- Chance levels: mean and standard deviation of the metrics over the surrogates of a series. Numbers of
-- the parts: 0 monotonicity, 1 temporal correlation, 2 robustness.
-- Reads:  part_means
-- A row:  one series.
SELECT
  group_id AS series_id,
  MAX(CASE WHEN part = 0 THEN part_mean END) AS mon_chance,
  MAX(CASE WHEN part = 0 THEN part_sd END) AS mon_chance_sd,
  MAX(CASE WHEN part = 1 THEN part_mean END) AS corr_chance,
  MAX(CASE WHEN part = 1 THEN part_sd END) AS corr_chance_sd,
  MAX(CASE WHEN part = 2 THEN part_mean END) AS rob_chance,
  MAX(CASE WHEN part = 2 THEN part_sd END) AS rob_chance_sd
FROM part_means
GROUP BY group_id
