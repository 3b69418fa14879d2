-- Apart: how far a point lies from another along one axis.
-- Slots:  :coordinate  of the point
--         :place       of the other
:coordinate - :place
