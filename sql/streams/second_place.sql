-- Second place: the block that visited a cell second, NULL if none did; a column of certificate/cells.sql. For
-- DuckDB, which finds the two least values in one pass; other engines look at visits again
-- (certificate/first_visits.sql). Proof: a place is one block, and a cell has one row of visits for each.
MIN(visit.place, 2)[2]
