-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Limited: the memory that DuckDB may use.
-- Slots:  :limit  such as '1GB'
SET memory_limit = :limit
