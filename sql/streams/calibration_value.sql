-- Calibration value: the value of a calibration sample, where it is not missing.
CASE WHEN code > 0 THEN value END
