-- Rules: how long calibration lasts (method, section 4), as given by the user. One of fraction,
-- duration and declared_end is set; none where a channel has no calibration of its own.
-- Repeated by Python, once per rule.
-- Slots:  :calibration_no  0 for the general rule
--         :fraction        share of the samples
--         :duration        length, in the unit of time
--         :declared_end    the largest end of the declared intervals
--         :score_from      first instant to be scored, where the user sets one
SELECT
  CAST(:calibration_no AS INTEGER) AS calibration_no,
  CAST(:fraction AS DOUBLE) AS fraction,
  CAST(:duration AS BIGINT) AS duration,
  CAST(:declared_end AS BIGINT) AS declared_end,
  CAST(:score_from AS BIGINT) AS score_from
