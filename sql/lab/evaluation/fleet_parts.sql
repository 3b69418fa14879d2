-- Fleet parts: the means and spreads of a drawing side by side. Numbers of the parts: 0 monotonicity,
-- 1 temporal correlation, 2 robustness, 3 last value and 4 amplitude of failed series, 5 standard
-- deviation of healthy series. Part -1 is there so that the fleet as it is has a row in any case.
-- Reads:  part_means
-- A row:  one drawing.
SELECT
  group_id AS drawing,
  MAX(CASE WHEN part = 0 THEN part_mean END) AS mon,
  MAX(CASE WHEN part = 0 THEN part_sd END) AS mon_sd,
  MAX(CASE WHEN part = 0 THEN counted ELSE 0 END) AS mon_counted,
  MAX(CASE WHEN part = 1 THEN part_mean END) AS corr_size,
  MAX(CASE WHEN part = 1 THEN part_sd END) AS corr_sd,
  MAX(CASE WHEN part = 1 THEN counted ELSE 0 END) AS corr_counted,
  MAX(CASE WHEN part = 2 THEN part_mean END) AS rob,
  MAX(CASE WHEN part = 2 THEN part_sd END) AS rob_sd,
  MAX(CASE WHEN part = 2 THEN counted ELSE 0 END) AS rob_counted,
  MAX(CASE WHEN part = 3 THEN part_sd END) AS last_sd,
  MAX(CASE WHEN part = 4 THEN part_mean END) AS amplitude,
  MAX(CASE WHEN part = 4 THEN counted ELSE 0 END) AS failed_counted,
  MAX(CASE WHEN part = 5 THEN part_mean END) AS healthy_sd,
  MAX(CASE WHEN part = 5 THEN counted ELSE 0 END) AS healthy_counted
FROM (
  SELECT group_id, part, counted, part_mean, part_sd
  FROM part_means
  UNION ALL
  SELECT
    0 AS group_id,
    -1 AS part,
    0 AS counted,
    CAST(0 AS DOUBLE) AS part_mean,
    CAST(0 AS DOUBLE) AS part_sd
) AS member_part
GROUP BY group_id
