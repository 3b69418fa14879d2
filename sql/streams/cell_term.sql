-- Cell term, in stored order: what one coordinate adds to the key of its cell (embedding/cell_term.sql), in numbers
-- that DuckDB adds up fastest. Repeated by Python, once per coordinate, and summed.
-- Slots:  :code    the coordinate
--         :weight  R^k
:code * CAST(:weight AS DOUBLE)
