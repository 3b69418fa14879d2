-- Figure: what one integer of a row adds to the checksum of its row; NULL adds nothing.
-- Slots:  :figure  the integer
--         :mixed   itself and the number of its column, by stored/mixed.sql
CASE WHEN :figure IS NOT NULL THEN :mixed ELSE 0 END
