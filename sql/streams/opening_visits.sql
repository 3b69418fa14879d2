-- Opening visits: how often its first block visited a cell; a column of certificate/cells.sql. For DuckDB, which
-- finds it in the same pass (ARG_MIN); other engines look at visits again (certificate/first_visits.sql). Proof: a
-- place is one block, and a cell has one row of visits for each.
ARG_MIN(visit.visits, visit.place)
