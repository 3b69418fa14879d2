-- Grafana channels: the values of the variable that chooses signals of the machines chosen.
-- Reads:  stored_fleet
-- A row:  one name of signals: what stands in a query, and what is shown.
-- Slots:  :monitor  its name
--         :assets   the machines that are chosen
--         :channel_value  its name as a text in a query is written, but for its quotes
SELECT CAST(:channel_value AS VARCHAR) AS __value, channel AS __text
FROM stored_fleet
WHERE monitor = :monitor AND asset IN (:assets)
GROUP BY channel
ORDER BY channel
