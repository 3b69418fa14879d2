-- Cell term, where supports are kept as bits: what one coordinate adds to the key of its cell
-- (embedding/cell_term.sql). Keys are below 2^25 there, which DOUBLE holds exactly and which DuckDB does not watch
-- for overflow. Repeated by Python, once per coordinate, and summed.
-- Slots:  :code    the coordinate
--         :weight  R^k
:code * CAST(:weight AS DOUBLE)
