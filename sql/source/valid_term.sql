-- Valid term: a reading for which the user's condition holds; any other one is missing (method, section 2).
-- Slots:  :valid    the condition
--         :reading  the numeric column
CASE WHEN :valid THEN :reading END
