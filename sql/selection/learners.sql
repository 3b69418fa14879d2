-- Learners: each channel at one embedding dimension, as a channel of its own: so the certificate judges
-- all dimensions at once. Repeated by Python, once per dimension, and stacked.
-- Reads:  bounds
-- A row:  one channel at one dimension, with an id of its own that is its support's, too.
-- Slots:  :m       the dimension, below 64
--         :window  W, for the step that divides by it
SELECT
  learner_id AS channel_id,
  learner_id AS support_id,
  taught_id,
  calibrated_lo,
  calibrated_hi,
  bins,
  CAST(:m AS INTEGER) AS m,
  CAST(:window AS BIGINT) AS window_length
FROM (
  SELECT
    CAST(channel_id AS BIGINT) * 64 + :m AS learner_id,
    channel_id AS taught_id,
    calibrated_lo,
    calibrated_hi,
    bins
  FROM bounds
) AS numbered
