-- Doubled: whether a sample has the instant of the one before it, so that the two should have been one.
-- Slots:  :previous_time  the instant of the sample before
position > 1 AND time = :previous_time
