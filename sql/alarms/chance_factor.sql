-- Chance factor: given that some blocks of a cell lie near a block, the chance that one more does, blocks being in
-- random order (alarms, section 3). Repeated by Python and multiplied.
-- Slots:  :i  how many lie there already
CAST(near_blocks - :i AS DOUBLE) / CAST(NULLIF(blocks - 1 - :i, 0) AS DOUBLE)
