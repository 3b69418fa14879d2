-- Number texts: is a text column made of numbers? The first thousand texts tell.
-- Reads:  source, the relation that holds the telemetry.
-- A row:  one, with the texts that were looked at and how many of them are numbers.
-- Slots:  :words      the column
--         :condition  the user's condition, TRUE where there is none
SELECT
  CAST(COUNT(*) AS BIGINT) AS texts,
  CAST(SUM(CASE WHEN TRY_CAST(worded.word AS DOUBLE) IS NULL THEN 0 ELSE 1 END) AS BIGINT) AS numbers
FROM (
  SELECT CAST(:words AS VARCHAR) AS word
  FROM source
  WHERE :words IS NOT NULL AND (:condition)
  LIMIT 1000
) AS worded
