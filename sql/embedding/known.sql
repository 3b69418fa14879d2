-- Known: whether a coordinate is there at all. Repeated by Python; all must hold.
-- Slots:  :code  the coordinate
:code > 0
