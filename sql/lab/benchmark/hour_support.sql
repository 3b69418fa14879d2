-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Hour, support: all cells.
SELECT support_id, cell_key
FROM gam_state_support
ORDER BY support_id
