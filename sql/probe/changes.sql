-- Changes: what is asked of a support: would it be seen if the machine changed so? Repeated by Python.
-- Slots:  :change_no, :change_name
--         :pace    which samples a vector holds; NULL where two of them would be one, so that it cannot be asked
--         :rung    its size, for a shift: percent of the usual width, either way
--         :shift   part of the usual width that is added; NULL for none
--         :stroke  factor of what lies beside the middle; NULL for none
SELECT
  CAST(:change_no AS INTEGER) AS change_no,
  :change_name AS change_name,
  CAST(:pace AS INTEGER) AS pace,
  CAST(:rung AS BIGINT) AS rung,
  CAST(:shift AS DOUBLE) AS shift,
  CAST(:stroke AS DOUBLE) AS stroke
