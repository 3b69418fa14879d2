-- Calibration from: where the rows of calibration begin that are counted anew; no instant where that is due for none.
-- Reads:  calibration
-- A row:  the only one.
-- Slots:  :earliest  no instant before it can be told
SELECT CASE WHEN MIN(piece.time_from) < :earliest THEN :earliest ELSE MIN(piece.time_from) END AS read_from
FROM calibration AS piece
