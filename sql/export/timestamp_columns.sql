-- Timestamp columns: whether the time column is of a type that a script was not made for. For MariaDB.
-- Dialect: mysql
-- Reads:  columns, the catalogue of the database.
-- A row:  the column, if it is.
-- Slots:  :schema      the schema of the source
--         :table       its name
--         :column      its time column
--         :is_counter  whether the script takes integers: a date or a timestamp is then of another type. Else a
--                      TIMESTAMP is, whose values each session reads in its own time zone
SELECT 1 AS hit
FROM information_schema.columns
WHERE table_schema = :schema
  AND table_name = :table
  AND column_name = :column
  AND (data_type = 'timestamp' OR (:is_counter = 1 AND data_type IN ('datetime', 'date', 'time')))
