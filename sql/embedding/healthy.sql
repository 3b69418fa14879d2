-- Healthy: whether every sample from the oldest of a vector to its newest is one of calibration (method, section 4).
oldest_time > last_uncalibrated
