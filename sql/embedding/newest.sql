-- Newest: the time of the newest sample of a kind, up to this one.
-- Slots:  :is_such   whether a sample is of the kind
--         :long_ago  an instant before all others
MAX(CASE WHEN :is_such THEN time ELSE CAST(:long_ago AS BIGINT) END) OVER (
  PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
)
