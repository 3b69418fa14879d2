-- Part means: weighted mean and standard deviation of each part over the series of a group.
-- Reads:  scaled
-- A row:  one part of one group.
-- Slots:  :ddof  what is taken from the sum of weights under the standard deviation
SELECT
  group_id,
  part,
  MAX(total_weight) AS counted,
  MAX(lowest) + (MAX(extent) * MAX(mean_share)) AS part_mean,
  MAX(extent) * SQRT(
    CAST(CAST(SUM(square_units * weight) AS BIGINT) AS DOUBLE) / MAX(units)
    / NULLIF(CAST(MAX(total_weight) - :ddof AS DOUBLE), CAST(0 AS DOUBLE))
  ) AS part_sd
FROM (
  SELECT
    group_id,
    part,
    weight,
    lowest,
    extent,
    units,
    total_weight,
    mean_share,
    CAST(
      FLOOR((share - mean_share) * (share - mean_share) * units + CAST(5e-1 AS DOUBLE)) AS BIGINT
    ) AS square_units
  FROM (
    SELECT
      group_id,
      part,
      weight,
      lowest,
      extent,
      units,
      share,
      total_weight,
      CAST(total_units AS DOUBLE) / units / CAST(total_weight AS DOUBLE) AS mean_share
    FROM (
      SELECT
        group_id,
        part,
        weight,
        lowest,
        extent,
        units,
        share,
        CAST(SUM(weight) OVER (PARTITION BY group_id, part) AS BIGINT) AS total_weight,
        CAST(SUM(share_units * weight) OVER (PARTITION BY group_id, part) AS BIGINT) AS total_units
      FROM scaled
    ) AS totalled
  ) AS averaged
) AS deviating
GROUP BY group_id, part
