-- Prog reason: why there is no prognosability.
CASE
  WHEN failed_counted = 0 THEN 'no_failed'
  WHEN failed_counted = 1 THEN 'one_failed'
  ELSE 'no_amplitude'
END
