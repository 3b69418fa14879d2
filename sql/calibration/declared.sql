-- Declared: the closed intervals that a rule allows, exclusions already taken out; disjoint.
-- Repeated by Python, once per interval. A rule by fraction or duration allows all of time but its
-- exclusions, and is cut to its length in the step calibration.
-- Slots:  :calibration_no, :time_from, :time_to
SELECT
  CAST(:calibration_no AS INTEGER) AS calibration_no,
  CAST(:time_from AS BIGINT) AS time_from,
  CAST(:time_to AS BIGINT) AS time_to
