-- Expansions (Cao 1997): by how much the distance of neighbours in the maximum norm grows with one
-- coordinate more, E(d), and how far that coordinate parts them, E*(d), as means. Summed in units of
-- 2^-24 and 2^-40; a ratio beyond 2^24 counts as 2^24.
-- Reads:  followed
-- A row:  one channel that has neighbours.
-- Slots:  :d  coordinates
SELECT
  channel_id,
  CAST(:d AS INTEGER) AS m,
  CAST(CAST(SUM(growth_units) AS BIGINT) AS DOUBLE) / CAST(16777216 AS DOUBLE)
  / CAST(COUNT(*) AS DOUBLE) AS growth,
  CAST(CAST(SUM(parting_units) AS BIGINT) AS DOUBLE) / CAST(1099511627776 AS DOUBLE)
  / CAST(COUNT(*) AS DOUBLE) AS mean_parting
FROM (
  SELECT
    channel_id,
    CAST(
      FLOOR(
        CASE
          WHEN parting <= distance THEN CAST(1 AS DOUBLE)
          WHEN parting > distance * CAST(16777216 AS DOUBLE) THEN CAST(16777216 AS DOUBLE)
          ELSE parting / distance
        END * CAST(16777216 AS DOUBLE) + CAST(5e-1 AS DOUBLE)
      ) AS BIGINT
    ) AS growth_units,
    CAST(
      FLOOR(parting * CAST(1099511627776 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT
    ) AS parting_units
  FROM followed
) AS counted
GROUP BY channel_id
