-- Newest, in stored order: as embedding/newest.sql. For DuckDB, which carries it along the rows as they are stored.
-- Proof: that of the vectors (streams/vectors.sql).
-- Slots:  :is_such   whether a sample is of the kind
--         :long_ago  an instant before all others
MAX(CASE WHEN :is_such THEN time ELSE CAST(:long_ago AS BIGINT) END) OVER (
  ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
)
