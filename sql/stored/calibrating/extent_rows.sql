-- Extent rows: how long the calibration of a new version is, and whether it is a fair sample of what follows.
-- Reads:  learnt_limits, numbering
-- A row:  one new version.
-- Slots:  :g  one of the widths that learnt_limits has rows for
SELECT
  numbered.version_id AS version_id,
  learnt.vectors AS vectors,
  learnt.calibration_length AS calibration_length,
  learnt.order_ratio AS order_ratio
FROM learnt_limits AS learnt
JOIN numbering AS numbered ON numbered.channel_id = learnt.channel_id
WHERE learnt.g = :g
