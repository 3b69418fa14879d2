-- Validity term: 1 where the user's condition holds for a row, else 0; it stands in the place of the reading.
-- Slots:  :valid  the condition
CASE WHEN :valid THEN 1 ELSE 0 END
