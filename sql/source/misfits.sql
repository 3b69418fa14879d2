-- Misfits: the words of a text column that cannot be read as what the column must hold. For DuckDB, which
-- gives rows in the order in which a file has them.
-- Dialect: duckdb
-- Reads:  source, the relation that holds the telemetry.
-- A row:  one such word, with how many rows hold it, how many rows hold any such word, and how many rows hold
--         a word; the first ones only.
-- Slots:  :words      the column, without the words that mean a missing value
--         :meant      the same as a number or a time, NULL where it is none
--         :condition  the user's condition, TRUE where there is none
--         :most       words that are wanted
SELECT
  grouped.word AS word,
  grouped.of_word AS of_word,
  grouped.of_all AS of_all,
  grouped.texts AS texts
FROM (
  SELECT
    worded.word AS word,
    CAST(COUNT(*) AS BIGINT) AS of_word,
    CAST(SUM(COUNT(*)) OVER () AS BIGINT) AS of_all,
    MIN(worded.texts) AS texts,
    MIN(worded.position) AS position
  FROM (
    SELECT
      CAST(:words AS VARCHAR) AS word,
      CASE WHEN :meant IS NULL THEN 1 ELSE 0 END AS is_misfit,
      COUNT(:words) OVER () AS texts,
      ROW_NUMBER() OVER () AS position
    FROM source
    WHERE :condition
  ) AS worded
  WHERE worded.is_misfit = 1 AND worded.word IS NOT NULL
  GROUP BY worded.word
) AS grouped
ORDER BY grouped.position
LIMIT :most
