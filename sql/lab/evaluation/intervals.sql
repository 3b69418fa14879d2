-- Intervals: a table of labels or alarms, in the words of the evaluation.
-- Reads:  intervals, the relation that holds it.
-- A row:  one row of it; both ends belong to it.
-- Slots:  :asset, :channel  the names, as text; channel NULL for all of the machine
--         :event            what happened, as text; NULL where the table does not tell
--         :start, :finish   integer microseconds (UTC) or an integer counter; NULL where there is none
--         :status, :is_open of an episode; NULL where the table does not tell
SELECT
  CAST(:asset AS VARCHAR) AS asset,
  CAST(:channel AS VARCHAR) AS channel,
  CAST(:event AS VARCHAR) AS event,
  CAST(:start AS BIGINT) AS starts_at,
  CAST(:finish AS BIGINT) AS ends_at,
  CASE WHEN :status = 'withdrawn' THEN 1 ELSE 0 END AS is_withdrawn,
  CASE WHEN :status = 'open' OR :is_open = 1 THEN 1 ELSE 0 END AS is_open
FROM intervals
