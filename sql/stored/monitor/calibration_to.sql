-- Calibration to: where they end.
-- Reads:  calibration
-- A row:  the only one.
-- Slots:  :latest  no instant after it can be told
SELECT CASE WHEN MAX(piece.time_to) >= :latest THEN :latest ELSE MAX(piece.time_to) + 1 END AS read_to
FROM calibration AS piece
