-- Blind reason: why no shift would be seen, where that is so: most readings lie in a small part of the range (range), parts of
-- calibration differ from each other (blocks), the grid tells too little (cells), or samples of a vector are too alike
-- (delay).
-- Slots:  none; over the range of a support, its sight and its cells
CASE
  WHEN scale.calibrated_hi - scale.calibrated_lo > 60 * probed.usual_width THEN 'range'
  WHEN probed.hi_limit > CAST(3e-1 AS DOUBLE) THEN 'blocks'
  WHEN learnt.cells < 8 THEN 'cells'
  ELSE 'delay'
END
