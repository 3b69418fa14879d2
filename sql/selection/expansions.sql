-- Expansions (Cao 1997): by how much the distance of neighbours in the maximum norm grows with one
-- coordinate more, E(d), and how far that coordinate parts them, E*(d), as means. Both are summed in
-- units of 2^-24.
-- Reads:  followed
-- A row:  one channel that has neighbours.
-- Slots:  :d  coordinates
SELECT
  channel_id,
  CAST(:d AS INTEGER) AS m,
  CAST(CAST(SUM(growth_units) AS BIGINT) AS DOUBLE) / CAST(16777216 AS DOUBLE)
  / CAST(COUNT(*) AS DOUBLE) AS growth,
  CAST(CAST(SUM(parting) AS BIGINT) AS DOUBLE) / CAST(16777216 AS DOUBLE)
  / CAST(COUNT(*) AS DOUBLE) AS mean_parting
FROM (
  SELECT
    channel_id,
    CAST(
      FLOOR(
        CASE
          WHEN parting <= distance THEN CAST(1 AS DOUBLE)
          ELSE CAST(parting AS DOUBLE) / CAST(distance AS DOUBLE)
        END * CAST(16777216 AS DOUBLE) + CAST(5e-1 AS DOUBLE)
      ) AS BIGINT
    ) AS growth_units,
    parting
  FROM followed
) AS counted
GROUP BY channel_id
