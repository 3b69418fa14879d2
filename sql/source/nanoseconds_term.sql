-- Nanoseconds term: whole nanoseconds since 1970 as microseconds, the one at or before (method, section 2).
-- Whole seconds apart from the rest of a second: both quotients are of a multiple of their divisor and
-- below 2^53, or stand half a nanosecond above a whole one, so that they need rounding only.
-- Slots:  :ticks  the column
CAST(
  FLOOR(
    CAST(:ticks - :ticks % 1000000000 AS DOUBLE) / CAST(1000000000 AS DOUBLE) + CAST(5e-1 AS DOUBLE)
  ) AS BIGINT
) * 1000000 + CAST(
  FLOOR((CAST(:ticks % 1000000000 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(1000 AS DOUBLE)) AS BIGINT
)
