-- In order: 1 if the rows of a name lie together and each is later than the one before; a column that the
-- names (source/names.sql) are given over as_stored.
CASE
  WHEN MAX(place) - MIN(place) + 1 = CAST(COUNT(*) AS BIGINT)
    AND MAX(CASE WHEN time > previous_time THEN 0 ELSE place END) <= MIN(place) THEN 1
  ELSE 0
END
