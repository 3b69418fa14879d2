-- Newest: the time of the newest sample of a kind, up to this one. Times grow along the order, so that it is also the
-- largest: some engines are told so.
-- Slots:  :is_such   whether a sample is of the kind
--         :long_ago  an instant before all others, where there is no such sample
COALESCE(
  LAST_VALUE(CASE WHEN :is_such THEN time END IGNORE NULLS) OVER (
    PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
  ),
  CAST(:long_ago AS BIGINT)
)
