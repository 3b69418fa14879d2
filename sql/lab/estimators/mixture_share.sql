-- Mixture share: what one component adds to the likelihood, relative to that of the strongest; less than
-- e^-700 is nothing. Repeated by Python, once per component, and summed.
-- Slots:  :log_density  of the component
CASE
  WHEN :log_density - peak > CAST(-7e2 AS DOUBLE) THEN EXP(:log_density - peak)
  ELSE CAST(0 AS DOUBLE)
END
