-- Box term: what one coordinate adds to the number of its box; the side of a box is a power of two, so
-- that the product is exact. Repeated by Python, once per coordinate with boxes, and summed.
-- Slots:  :coordinate
--         :per_side  1 / the side, in units
--         :weight    beyond the number of boxes along the range, to the power of j
(CAST(FLOOR(CAST(:coordinate AS DOUBLE) * CAST(:per_side AS DOUBLE)) AS BIGINT) + 1)
* CAST(:weight AS BIGINT)
