-- Truth term: a truth value as a reading, 0 or 1 (method, section 2).
-- Slots:  :flag  the column
CASE WHEN :flag THEN 1 WHEN NOT :flag THEN 0 END
