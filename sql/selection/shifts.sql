-- Shifts: from a box to itself and each of its neighbours, as a difference of box numbers.
-- Repeated by Python, once per neighbour.
-- Slots:  :shift
SELECT CAST(:shift AS BIGINT) AS shift
