-- Key term: what the program adds to the key of a cell, read off the key.
-- Slots:  :weight  R^m, with R = bins + 3
(cell_key - cell_key % :weight)
