-- Timestamp columns: whether the time column is of a type that a script was not made for. For MariaDB.
-- Dialect: mysql
-- Reads:  columns, the catalogue of the database.
-- A row:  the column, if it is.
-- Slots:  :schema    the schema of the source
--         :table     its name
--         :column    its time column
--         :is_other  the condition on data_type, its type: a TIMESTAMP, whose values each session reads in its
--                    own time zone; or any date or time, where the script takes integers
SELECT 1 AS hit
FROM information_schema.columns
WHERE table_schema = :schema AND table_name = :table AND column_name = :column AND :is_other
