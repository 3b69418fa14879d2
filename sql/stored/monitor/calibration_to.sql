-- Calibration to: where they end.
-- Reads:  calibration
-- A row:  the only one.
-- Slots:  :earliest, :latest  no instant before, or after, can be told
SELECT
  CASE
    WHEN MAX(piece.time_to) >= :latest THEN :latest
    WHEN MAX(piece.time_to) >= :earliest THEN MAX(piece.time_to) + 1
    ELSE :earliest
  END AS read_to
FROM calibration AS piece
