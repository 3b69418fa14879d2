-- Counted level: the indicator as the integer that it is, the novel vectors in its window.
novel_in_window - lowest_count
