-- Intervals: a table of labels or alarms, in the words of the evaluation.
-- Reads:  intervals, the relation that holds it.
-- A row:  one row of it; both ends belong to it.
-- Slots:  :asset, :channel  the names, as text; channel NULL for all of the machine
--         :event            what happened, as text; NULL where the table does not tell
--         :start, :finish   integer microseconds (UTC) or an integer counter; NULL where there is none
SELECT
  CAST(:asset AS VARCHAR) AS asset,
  CAST(:channel AS VARCHAR) AS channel,
  CAST(:event AS VARCHAR) AS event,
  CAST(:start AS BIGINT) AS starts_at,
  CAST(:finish AS BIGINT) AS ends_at
FROM intervals
