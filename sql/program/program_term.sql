-- Program term: what the program adds to the key of a cell, as its highest digit (both sides, section 5).
-- Slots:  :weight  R^m, with R = bins + 3
program_no * CAST(:weight AS BIGINT)
