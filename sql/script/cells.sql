-- Cells, the support: those that healthy operation visits (Eq. 3).
-- Reads:  vectors
-- Slots:  :taught  whether calibration teaches a vector
SELECT DISTINCT asset, channel, cell_key
FROM vectors
WHERE cell_key IS NOT NULL AND :taught
