-- Decimal term: seconds, or parts of them, since 1970 as a decimal number, as whole smaller units: the one
-- at or before (method, section 2). What lies beyond 64 bits is no time.
-- Slots:  :ticks     the column
--         :smaller   smaller units in one of its own
--         :farthest  the largest number that is a time
CASE
  WHEN :ticks BETWEEN -:farthest AND :farthest THEN CAST(FLOOR(:ticks * :smaller) AS BIGINT)
END
