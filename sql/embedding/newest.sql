-- Newest: the time of the newest sample of a kind among this one and some before it, or an instant before all others.
-- Farther back it does not matter when that was. Times grow along the order, so that it is also the largest of all up to
-- this one, if it is among them: engines are told so that do not ask for it more cheaply.
-- Slots:  :is_such   whether a sample is of the kind
--         :rows      how many samples before this one matter
--         :long_ago  an instant before all others
COALESCE(
  LAST_VALUE(CASE WHEN :is_such THEN time END IGNORE NULLS) OVER (
    PARTITION BY channel_id ORDER BY time ROWS BETWEEN :rows PRECEDING AND CURRENT ROW
  ),
  CAST(:long_ago AS BIGINT)
)
