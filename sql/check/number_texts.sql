-- Number texts: the first thousand texts of a column, which tell whether it holds numbers. What a number is must not hang
-- on the engine: some refuse a text that is none, some take it for 0.
-- Reads:  source, the relation that holds the telemetry.
-- A row:  one text.
-- Slots:  :words      the column
--         :condition  the user's condition, TRUE where there is none
SELECT CAST(:words AS VARCHAR) AS word
FROM source
WHERE :words IS NOT NULL AND (:condition)
LIMIT 1000
