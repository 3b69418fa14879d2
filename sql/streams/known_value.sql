-- Known value: that of a sample of calibration, where it is not missing.
CASE WHEN code > 0 THEN value END
