-- Disc reason: why there is no discriminability.
CASE
  WHEN failed_counted = 0 THEN 'no_failed'
  WHEN healthy_counted = 0 THEN 'no_healthy'
  ELSE 'no_amplitude'
END
