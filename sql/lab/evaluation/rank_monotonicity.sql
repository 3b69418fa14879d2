-- Rank monotonicity: Spearman's correlation of the indicator with time, ties averaged (Eq. 5).
CAST(rank_time_sum AS DOUBLE)
/ NULLIF(SQRT(CAST(rank_square_sum AS DOUBLE) * CAST(time_square_sum AS DOUBLE)), CAST(0 AS DOUBLE))
