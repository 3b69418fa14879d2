-- Present: whether a coordinate is there at all. Python repeats it; all must hold.
-- Slots:  :code  the coordinate
:code > 0
