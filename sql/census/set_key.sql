-- Set key: a cell of a support as one number, which costs less to look up than two. Python takes it where 2^23
-- supports have room: R^m is at most 2^40.
-- Slots:  :support_id
--         :cells  R^m, more than any key
--         :cell_key
:support_id * CAST(:cells AS BIGINT) + :cell_key
