-- Straddling: whether a coordinate is a sample of calibration (method, section 4). Repeated by Python; one suffices.
-- Slots:  :calibrating  1 if it is
:calibrating = 1
