-- Code term: what one coordinate adds to the key of its cell. Repeated by Python, once per coordinate, and
-- summed.
-- Slots:  :code
--         :weight  R^k, with R = bins + 3
CAST(:code AS BIGINT) * CAST(:weight AS BIGINT)
