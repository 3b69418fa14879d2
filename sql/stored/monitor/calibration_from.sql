-- Calibration from: where the rows of calibration begin that are counted anew; none are touched where that is not due.
-- Reads:  calibration
-- A row:  the only one.
-- Slots:  :earliest, :latest  no instant before, or after, can be told
SELECT
  CASE
    WHEN MIN(piece.time_from) < :earliest THEN :earliest
    WHEN MIN(piece.time_from) < :latest THEN MIN(piece.time_from)
    ELSE :latest
  END AS read_from
FROM calibration AS piece
