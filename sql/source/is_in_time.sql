-- Is in time: whether a row is not later than an instant. A row without a time is: others refuse or count it.
-- Slots:  :time    the column as integer microseconds
--         :latest  the latest instant that counts, likewise
CASE WHEN :time > :latest THEN 0 ELSE 1 END = 1
