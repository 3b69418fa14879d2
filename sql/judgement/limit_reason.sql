-- Limit reason: why a channel has no limit; NULL where it has one.
-- Slots:  :verdict  of the certificate
CASE
  WHEN :verdict = 'no_data' THEN 'no calibration'
  WHEN :verdict = 'constant' THEN 'constant in calibration'
  WHEN :verdict = 'too_fine' THEN 'grid too fine for its calibration'
  WHEN :verdict = 'needs_data' THEN 'calibration too short'
  WHEN :verdict = 'not_vouched' THEN 'only one machine of its pool taught'
END
