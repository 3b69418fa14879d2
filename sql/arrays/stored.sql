-- Stored, in arrays: all samples of the source, in order, a channel in a row; read once, for the census and for the
-- vectors. For ClickHouse, where windows and joins of rows cost most of all. Proof, in the same statement: doubled
-- = 1 where an instant of a channel occurs twice, which is then done again by windows.
-- Dialect: clickhouse
-- Reads:  readings
-- A row:  one (asset, channel) pair, kept: the times and values of its samples. What is not a number between -1e300
--         and 1e300 is missing, a NaN here. Rows without a time are counted; their source is refused.
SELECT
  asset,
  channel,
  times,
  samples,
  without_time,
  CASE WHEN arrayCount(step -> step = 0, arrayDifference(times)) > 1 THEN 1 ELSE 0 END AS doubled
FROM (
  SELECT
    asset,
    channel,
    without_time,
    arraySort(times_as_stored) AS times,
    arraySort((value, time) -> time, samples_as_stored, times_as_stored) AS samples
  FROM (
    SELECT
      asset,
      channel,
      COUNT(*) - COUNT(time) AS without_time,
      groupArray(assumeNotNull(time)) AS times_as_stored,
      groupArray(
        assumeNotNull(CASE WHEN reading BETWEEN -1e300 AND 1e300 THEN reading ELSE nan END)
      ) AS samples_as_stored
    FROM readings
    GROUP BY asset, channel
  ) AS gathered
) AS ordered
