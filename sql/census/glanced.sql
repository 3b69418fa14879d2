-- Glanced: how many names the first rows of the source have, and how many half of them. It decides into how many slices
-- times are cut: a guess, which costs time where it is wrong, never a number.
-- Reads:  readings
-- A row:  the only one.
-- Slots:  :rows  that are looked at
--         :half  half of them
SELECT seen.names AS names, part.names AS names_of_half
FROM (
  SELECT CAST(COUNT(*) AS BIGINT) AS names
  FROM (
    SELECT asset, channel
    FROM (
      SELECT asset, channel
      FROM readings
      LIMIT :rows
    ) AS first_rows
    GROUP BY asset, channel
  ) AS named
) AS seen
CROSS JOIN (
  SELECT CAST(COUNT(*) AS BIGINT) AS names
  FROM (
    SELECT asset, channel
    FROM (
      SELECT asset, channel
      FROM readings
      LIMIT :half
    ) AS first_rows
    GROUP BY asset, channel
  ) AS named
) AS part
