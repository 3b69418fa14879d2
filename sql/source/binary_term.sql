-- Binary term: seconds, or parts of them, since 1970 as a floating-point number, as microseconds: the
-- nearest one (method, section 2). What lies beyond 64 bits is no time.
-- Slots:  :ticks     the column
--         :micros    microseconds in one of its units, and
--         :parts     its units in one microsecond; one of the two is 1
--         :farthest  the largest number that is a time
CASE
  WHEN :ticks BETWEEN -:farthest AND :farthest
  THEN CAST(
    FLOOR(:ticks * CAST(:micros AS DOUBLE) / CAST(:parts AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT
  )
END
