-- Grafana assets: the values of the variable that chooses machines.
-- Reads:  stored_machine
-- A row:  one machine: what stands in a query, and what is shown.
-- Slots:  :monitor   its name
--         :asset_value  its name as a text in a query is written, but for its quotes
SELECT CAST(:asset_value AS VARCHAR) AS __value, asset AS __text
FROM stored_machine
WHERE monitor = :monitor
ORDER BY asset
