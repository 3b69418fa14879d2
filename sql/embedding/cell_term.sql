-- Cell term: what one coordinate adds to the key of its cell, code * R^k with R = bins + 3
-- (method, section 3). Repeated by Python, once per coordinate, and summed.
-- Slots:  :code    the coordinate
--         :weight  R^k
CAST(:code AS BIGINT) * CAST(:weight AS BIGINT)
