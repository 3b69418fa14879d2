-- In order: 1 if each row of a channel is later than the one that is stored before it; a column of
-- streams/names.sql.
CASE
  WHEN CAST(COUNT(CASE WHEN time > previous_time THEN 1 END) AS BIGINT) = CAST(COUNT(*) AS BIGINT) - 1 THEN 1
  ELSE 0
END
