-- Limit: the health indicator that healthy operation stays below: the largest of twice the floor, the highest block of
-- calibration and the target, so more than calibration ever showed and more than the user is willing to call healthy.
-- NULL where calibration has too few blocks.
-- Slots:  :floor, :floor_max  of the certificate
--         :target_floor       health indicator that a healthy machine may show
CASE
  WHEN :floor IS NULL OR :floor_max IS NULL THEN NULL
  WHEN 2 * :floor >= :floor_max AND 2 * :floor >= :target_floor THEN 2 * :floor
  WHEN :floor_max >= :target_floor THEN :floor_max
  ELSE :target_floor
END
