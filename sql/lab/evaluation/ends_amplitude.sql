-- Ends amplitude: the last value less the first.
last_hi - first_hi
