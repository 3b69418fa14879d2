-- Sign monotonicity: rises less falls from one value to the next, over their number (Coble and Hines).
CAST(rises_less_falls AS DOUBLE) / NULLIF(CAST(k - 1 AS DOUBLE), CAST(0 AS DOUBLE))
