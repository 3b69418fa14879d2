-- In calibration: whether every sample from a vector's oldest to its newest is one of calibration (method, section 4).
oldest_time > last_uncalibrated
