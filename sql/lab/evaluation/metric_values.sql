-- Metric values: one metric of the fleet under every drawing.
-- Reads:  fleet_metrics
-- A row:  one drawing.
-- Slots:  :metric   its name
--         :number   its place in the summary
--         :value    its column
--         :spread   the column of its standard deviation over series, or NULL
--         :counted  the column of the number of series or metrics that it averages
--         :reason   why it is NULL
SELECT
  drawing,
  :metric AS metric,
  CAST(:number AS BIGINT) AS metric_no,
  CAST(:value AS DOUBLE) AS metric_value,
  CAST(:spread AS DOUBLE) AS spread,
  CAST(:counted AS BIGINT) AS counted,
  CASE WHEN :value IS NULL THEN :reason END AS reason
FROM fleet_metrics
