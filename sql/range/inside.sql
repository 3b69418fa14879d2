-- Inside: whether no coordinate of a vector lies outside the calibrated range, as one does that holds a dropped sample.
out_of_range = 0
