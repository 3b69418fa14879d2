-- Calibration range: between which instants the rows of calibration lie, for a group of channels.
-- Reads:  calibration
-- A row:  the only one; NULL where no channel of the group has an interval of its own.
SELECT MIN(piece.time_from) AS earliest, MAX(piece.time_to) AS latest
FROM calibration AS piece
