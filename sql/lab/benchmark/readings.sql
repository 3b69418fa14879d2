-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Readings: the raw table that every program starts from.
CREATE TABLE readings (asset VARCHAR, channel VARCHAR, t BIGINT, value DOUBLE)
