-- Set key: one number for a cell of a support, where all of them have one: to look up one number costs less than to
-- look up two.
-- Slots:  :support_id
--         :cells  R^m, more than any key
--         :cell_key
:support_id * CAST(:cells AS BIGINT) + :cell_key
