-- Piece: in which of 128 equal pieces of a range a sample lies, from 0. What comes to 128 by rounding, and all of a
-- range that is one value, belongs to the last.
-- Slots:  :place  the expression of support/place.sql for 128 bins
CASE WHEN :place < CAST(128 AS DOUBLE) THEN FLOOR(:place) ELSE 127 END
