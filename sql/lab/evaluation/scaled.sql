-- Scaled: the parts as shares of the way from the lowest to the highest value of their kind, and in
-- whole units of it.
-- Reads:  drawn
-- A row:  one part of one series in one group.
-- Slots:  :units  a power of two; times the largest sum of weights of a group it stays below 2^62
SELECT
  group_id,
  part,
  weight,
  lowest,
  extent,
  units,
  share,
  CAST(FLOOR(share * units + CAST(5e-1 AS DOUBLE)) AS BIGINT) AS share_units
FROM (
  SELECT
    group_id,
    part,
    weight,
    lowest,
    highest - lowest AS extent,
    CAST(:units AS DOUBLE) AS units,
    CASE
      WHEN highest > lowest THEN (part_value - lowest) / (highest - lowest)
      ELSE CAST(0 AS DOUBLE)
    END AS share
  FROM (
    SELECT
      group_id,
      part,
      weight,
      part_value,
      MIN(part_value) OVER (PARTITION BY part) AS lowest,
      MAX(part_value) OVER (PARTITION BY part) AS highest
    FROM drawn
  ) AS bounded
) AS shared
