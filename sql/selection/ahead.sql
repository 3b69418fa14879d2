-- Ahead: the coordinate that is joined. Chained by Python.
CASE WHEN later.hit = 1 THEN later.u_0 END
