-- Undeclared: the declared intervals where no rule has any.
-- Reads:  rules
SELECT calibration_no, declared_end AS time_from, declared_end AS time_to
FROM rules
WHERE 1 = 0
