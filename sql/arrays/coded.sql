-- Coded, in arrays: all samples of the channels with a range, coded (Phi, method section 3), a channel in a row,
-- as they are stored; names are joined once per channel, and nothing is sorted. For ClickHouse, where windows and
-- joins of rows cost most of all. Proof, in the same statement: times grow from one to the next, or the channel is
-- sorted; doubled = 1 where an instant occurs twice, and then all is done again by windows.
-- Dialect: clickhouse
-- Reads:  readings, scale
-- A row:  one channel, kept: the times and codes of its samples in order. What is not a number between -1e300
--         and 1e300 is missing.
-- Slots:  :code  the expression of support/code.sql, cast to the narrowest integer that holds it
SELECT
  channel_id,
  support_id,
  complete,
  read_from,
  taught_from,
  taught_to,
  times,
  CASE
    WHEN in_order THEN codes_as_stored
    ELSE arraySort((code, time) -> time, codes_as_stored, times_as_stored)
  END AS codes,
  CASE
    WHEN in_order THEN 0
    WHEN arrayExists((earlier, later) -> earlier = later, arrayPopBack(times), arrayPopFront(times)) THEN 1
    ELSE 0
  END AS doubled
FROM (
  SELECT
    channel_id,
    support_id,
    complete,
    read_from,
    taught_from,
    taught_to,
    times_as_stored,
    arrayMap(value -> assumeNotNull(:code), values_as_stored) AS codes_as_stored,
    in_order,
    CASE WHEN in_order THEN times_as_stored ELSE arraySort(times_as_stored) END AS times
  FROM (
    SELECT
      scale.channel_id AS channel_id,
      scale.support_id AS support_id,
      scale.complete AS complete,
      scale.read_from AS read_from,
      scale.taught_from AS taught_from,
      scale.taught_to AS taught_to,
      scale.lo AS lo,
      scale.hi AS hi,
      stored.times AS times_as_stored,
      arrayMap(
        reading -> CASE WHEN reading BETWEEN -1e300 AND 1e300 THEN reading END, stored.readings
      ) AS values_as_stored,
      arrayAll(
        (earlier, later) -> earlier < later, arrayPopBack(stored.times), arrayPopFront(stored.times)
      ) AS in_order
    FROM (
      SELECT
        asset,
        channel,
        groupArray(assumeNotNull(time)) AS times,
        groupArray(ifNull(reading, nan)) AS readings
      FROM readings
      WHERE time IS NOT NULL
      GROUP BY asset, channel
    ) AS stored
    JOIN scale ON scale.asset = stored.asset AND scale.channel = stored.channel
  ) AS ranged
) AS ordered
