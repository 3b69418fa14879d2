-- Outside: whether a coordinate lies outside the calibrated range. Repeated by Python; one suffices.
-- Slots:  :code  the coordinate
--         :above the code of all that lies above the range, bins + 2
:code = 1 OR :code = :above
