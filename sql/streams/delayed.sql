-- Delayed, in stored order: the value of a column that many rows before; see streams/vectors.sql.
-- Slots:  :column, :delay
LAG(:column, :delay) OVER ()
