-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Attached: the telemetry lies in a file of its own, so that a copy of the state is a small file.
-- Slots:  :path
ATTACH :path AS telemetry (READ_ONLY)
