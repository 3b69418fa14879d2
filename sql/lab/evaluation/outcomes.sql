-- Outcomes: what became of assets, in the words of the evaluation.
-- Reads:  outcomes, the relation that holds them.
-- A row:  one row of it.
-- Slots:  :asset, :channel  the names, as text; channel NULL for all of them
--         :failed_at        integer microseconds (UTC) or an integer counter
--         :dated            the column as it is given, to tell whether there is anything in it
--         :healthy          true or 1, false or 0, NULL where it is not said
SELECT
  CAST(:asset AS VARCHAR) AS asset,
  CAST(:channel AS VARCHAR) AS channel,
  CAST(:failed_at AS BIGINT) AS failed_at,
  CASE WHEN :dated IS NULL THEN 0 ELSE 1 END AS is_dated,
  CAST(:healthy AS BIGINT) AS healthy
FROM outcomes
