-- Chance parts: a metric of every surrogate, under the series that it stands for.
-- Reads:  series_metrics, surrogates
-- A row:  one surrogate that has the metric.
-- Slots:  :part      number of the metric
--         :quantity  its column
SELECT
  surrogate.stands_for AS group_id,
  :part AS part,
  :quantity AS part_value,
  1 AS weight
FROM series_metrics AS measured
JOIN surrogates AS surrogate ON surrogate.series_id = measured.series_id
WHERE :quantity IS NOT NULL
