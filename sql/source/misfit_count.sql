-- Misfit count: how many words of a text column cannot be read as what the column must hold; see misfits.
-- Dialect: duckdb
-- Reads:  source, the relation that holds the telemetry.
-- A row:  the only one.
-- Slots:  :words      the column, without the words that mean a missing value
--         :meant      the same as a number or a time, NULL where it is none
--         :condition  which rows count
SELECT CAST(COUNT(*) AS BIGINT) AS misfits
FROM source
WHERE :condition AND :words IS NOT NULL AND :meant IS NULL
