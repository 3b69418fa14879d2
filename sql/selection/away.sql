-- Away: how far apart two vectors are in one coordinate, in units. Repeated by Python, once per coordinate.
-- Slots:  :here, :there
ABS(CAST(:here AS BIGINT) - CAST(:there AS BIGINT))
