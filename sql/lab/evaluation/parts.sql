-- Parts: one of the quantities that the fleet's metrics average, of each series that has it.
-- Reads:  rated
-- A row:  one series.
-- Slots:  :part         number of the quantity
--         :quantity     its column
--         :from_stratum  the series that it is taken from
--         :with_outcome  1 if only those whose outcome is known
SELECT stratum, asset_no, :part AS part, :quantity AS part_value
FROM rated
WHERE stratum = :from_stratum AND has_outcome >= :with_outcome AND :quantity IS NOT NULL
