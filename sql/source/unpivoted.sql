-- Unpivoted: the rows of a wide table, in the method's words, one for each of its columns; as readings, which
-- takes a branch for each column and so much longer to plan where they are many.
-- Reads:  source, the relation that holds the telemetry.
-- A row:  one column in one row of the source; a missing value is a row all the same.
-- Slots:  :asset      the name, as text; a constant where the source has no such column
--         :time       integer microseconds (UTC) or an integer counter
--         :columns    the numeric columns, as column_1, column_2, ...
--         :named      the same, each with its channel
--         :condition  the user's condition, TRUE where there is none
--         :program, :carried  what a machine runs, as text; nothing where no column says so
SELECT
  wide_rows.asset AS asset,
  wide_rows.channel AS channel,
  wide_rows.time AS time,
  wide_rows.reading AS reading,
  :carried
FROM (
  SELECT
    CAST(:asset AS VARCHAR) AS asset,
    :time AS time,
    :program,
    :columns
  FROM source
  WHERE :condition
) AS wide
UNPIVOT INCLUDE NULLS (reading FOR channel IN (:named)) AS wide_rows
