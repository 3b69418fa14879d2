-- Delayed, in stored order: the value of a column that many rows before. For DuckDB, whose LAG without an order
-- follows the rows as they are stored, so that nothing is sorted. Proof: that of the vectors (streams/vectors.sql,
-- rounds/vectors.sql).
-- Slots:  :column, :delay
LAG(:column, :delay) OVER ()
