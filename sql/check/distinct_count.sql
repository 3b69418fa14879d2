-- Distinct count: how many different values a column has.
-- Slots:  :column  the column
CAST(COUNT(DISTINCT :column) AS BIGINT)
