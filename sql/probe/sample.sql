-- Sample: one sample of a vector after a change. Repeated by Python, once per coordinate.
-- Slots:  :usual   the sample as it is, k * tau before the newest one
--         :paced   the one that takes its place at the pace of the change
CASE
  WHEN asked.shift IS NOT NULL THEN :usual + asked.shift * middle.width
  WHEN asked.stroke IS NOT NULL THEN middle.q50 + asked.stroke * (:usual - middle.q50)
  ELSE :paced
END
