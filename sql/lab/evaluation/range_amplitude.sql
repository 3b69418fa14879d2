-- Range amplitude: the highest value less the lowest.
highest_hi - lowest_hi
