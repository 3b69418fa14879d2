-- Cell term, where supports are kept as bits: what one coordinate adds to the key of its cell
-- (embedding/cell_term.sql). For DuckDB, which watches whole numbers for overflow and DOUBLE not. Proof: keys are
-- below 2^25 there, which DOUBLE holds exactly. Repeated by Python, once per coordinate, and summed.
-- Slots:  :code    the coordinate
--         :weight  R^k
:code * CAST(:weight AS DOUBLE)
