-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Readings by id: the same rows with an integer in the place of the two names, for the floor.
CREATE TABLE readings_by_id (channel_id INTEGER, t BIGINT, value DOUBLE)
