-- Second place: the block that visited a cell second, NULL if none did; a column of certificate/cells.sql. DuckDB finds the
-- two least values in one pass; other engines look at visits again (certificate/first_visits.sql).
MIN(visit.place, 2)[2]
