-- Delayed, by row: which row holds the sample so many before. Repeated by Python, once per delay. For SQLite, which
-- finds a row by its number at less cost than by a window. Proof: that of rowids/vectors.sql.
-- Dialect: sqlite
-- Slots:  :row    the number of that row
--         :delay  k * tau, in samples
:row = newest.rowid - :delay
