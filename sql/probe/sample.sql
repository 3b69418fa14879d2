-- Sample: one sample of a vector after a change. Repeated by Python, once per coordinate. Below 1e-290 a product of doubles
-- may come to nothing, which PostgreSQL refuses: so small a width or stroke does not change a sample.
-- Slots:  :usual   the sample as it is, k * tau before the newest one
--         :paced   the one that takes its place at the pace of the change
CASE
  WHEN change.shift IS NOT NULL
    THEN :usual + CASE
      WHEN middle.width > CAST(1e-290 AS DOUBLE) THEN change.shift * middle.width
      ELSE CAST(0 AS DOUBLE)
    END
  WHEN change.stroke IS NOT NULL
    THEN CASE
      WHEN :usual - middle.q50 BETWEEN CAST(-1e-290 AS DOUBLE) AND CAST(1e-290 AS DOUBLE) THEN :usual
      ELSE middle.q50 + change.stroke * (:usual - middle.q50)
    END
  ELSE :paced
END
