-- Away: how far apart two vectors are in one coordinate. Repeated by Python, once per coordinate.
-- Slots:  :here, :there
ABS(:here - :there)
