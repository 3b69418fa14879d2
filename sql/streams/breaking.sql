-- Breaking, in stored order: 1 if a segment begins with a sample: a step in time larger than max_gap ends one (method,
-- section 1). For DuckDB, whose LAG without an order follows the rows as they are stored. Proof: that of the vectors
-- (streams/vectors.sql).
-- Slots:  :max_gap  the longest step inside a segment, in the unit of time
CASE WHEN time - LAG(time, 1) OVER () > :max_gap THEN 1 ELSE 0 END
