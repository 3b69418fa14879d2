-- Chance factor: given that some blocks of a cell lie near a block, the chance that one more does, blocks being in
-- random order (alarms, section 3). Repeated by Python and multiplied. A cell lies in no more blocks than there are; for
-- more, which nobody asks for, nothing is divided by 0: ClickHouse would carry that on behind a NULL.
-- Slots:  :i  how many lie there already
CAST(near_blocks - :i AS DOUBLE) / CAST(CASE WHEN blocks - 1 > :i THEN blocks - 1 - :i ELSE 1 END AS DOUBLE)
