-- Latest: the latest instant of a row that counts.
-- Reads:  clock
-- A row:  the only one.
SELECT watch.latest AS latest
FROM clock AS watch
