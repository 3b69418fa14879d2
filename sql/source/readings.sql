-- Readings: the rows of a long table, in the method's words (method, section 2).
-- Reads:  source, the relation that holds the telemetry.
-- A row:  one row of the source; nothing is left out but what the user's own condition excludes.
-- Slots:  :asset, :channel  the names, as text; a constant where the source has no such column
--         :time             integer microseconds (UTC) or an integer counter
--         :reading          the numeric column
--         :condition        the user's condition, TRUE where there is none
--         :program, :carried  what a machine runs, as text; nothing where no column says so
SELECT
  source_rows.asset_name AS asset,
  source_rows.channel_name AS channel,
  source_rows.instant AS time,
  source_rows.reading AS reading,
  :carried
FROM (
  SELECT
    CAST(:asset AS VARCHAR) AS asset_name,
    CAST(:channel AS VARCHAR) AS channel_name,
    :time AS instant,
    CAST(:reading AS DOUBLE) AS reading,
    :program
  FROM source
  WHERE :condition
) AS source_rows
