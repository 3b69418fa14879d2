-- Trendability reason: why there is none.
CASE
  WHEN failed_counted = 0 THEN 'no_failed'
  WHEN failed_counted = 1 THEN 'one_failed'
  ELSE 'constant'
END
