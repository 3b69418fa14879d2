-- Misplaced: whether a row is not of the channel whose turn it is, or not later than the one a round before.
-- Slots:  :previous_time  the instant of that one
in_turn = 0 OR time <= :previous_time
