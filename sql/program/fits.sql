-- Fits: whether the program of a sample has a number, and one with which the key of a cell fits into 64 bits.
-- Slots:  :most  the largest such number
program_no <= :most
