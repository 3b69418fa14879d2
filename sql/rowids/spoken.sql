-- Spoken: the names that the source speaks of, in order, so that the number of a row (rowid) stands for both of them
-- where samples are sorted. For SQLite: DISTINCT alone sorts nothing; with the order beside it, it would. Proof: none
-- is needed; it reads all rows.
-- Dialect: sqlite
-- Reads:  readings
-- A row:  one (asset, channel) pair, a missing name included.
SELECT asset, channel
FROM (SELECT DISTINCT asset, channel FROM readings) AS named
ORDER BY asset, channel
