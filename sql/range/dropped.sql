-- Dropped: what was left out of the range of a support, as a column of support/bounds.sql: a member of a pool without
-- calibration of its own has that of the others. Repeated by Python.
-- Slots:  :column   of range/kept.sql
--         :nothing  what it is where the support has no calibration sample
COALESCE(MAX(CASE WHEN seen.hit = 1 THEN :column END) OVER (PARTITION BY named.support_id), :nothing)
