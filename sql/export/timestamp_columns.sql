-- Timestamp columns: whether the time column is one whose values a session reads in its own time zone. For MariaDB.
-- Dialect: mysql
-- Reads:  columns, the catalogue of the database.
-- A row:  the column, if it is.
-- Slots:  :schema  the schema of the source
--         :table   its name
--         :column  its time column
SELECT 1 AS hit
FROM information_schema.columns
WHERE table_schema = :schema AND table_name = :table AND column_name = :column AND data_type = 'timestamp'
