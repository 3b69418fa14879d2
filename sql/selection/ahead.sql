-- Ahead: the coordinate that is joined, or its code. Chained by Python.
-- Slots:  :later
CASE WHEN later.hit = 1 THEN :later END
