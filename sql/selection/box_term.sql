-- Box term: what one coordinate adds to the number of its box; the side of a box is a power of two, so
-- that the product is exact. Repeated by Python, once per coordinate with boxes, and summed.
-- Slots:  :coordinate
--         :boxes   along the range
--         :weight  (boxes + 3)^j
(CAST(FLOOR(:coordinate * CAST(:boxes AS DOUBLE)) AS BIGINT) + 1) * CAST(:weight AS BIGINT)
