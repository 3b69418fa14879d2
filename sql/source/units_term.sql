-- Units term: whole seconds, milliseconds or microseconds since 1970 as microseconds (method, section 2).
-- Slots:  :ticks   the column
--         :micros  microseconds in one of its units
CAST(:ticks AS BIGINT) * CAST(:micros AS BIGINT)
