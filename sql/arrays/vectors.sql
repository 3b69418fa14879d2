-- Vectors in arrays: v(t) (Eq. 1) of samples that lie in one array per channel and are coded there (Phi, method
-- section 3). For ClickHouse, where windows cost most of all: a delay is the same array from another place on. Proof:
-- stored, whose arrays are in order.
-- Dialect: clickhouse
-- Reads:  stored, scale
-- A row:  one vector, at the time of its newest sample; cell_key is NULL where a sample is missing; position
--         counts the samples from the first one that is read.
-- Slots:  :time_from, :time_to  the instants of a channel that are read
--         :span                 (m-1) * tau, the samples between oldest and newest
--         :code                 the expression of support/code.sql, cast to the narrowest integer that holds it
--         :delayed              code_0 ... code_(m-1), the arrays of the coordinates
--         :coordinates          their names
--         :is_present           all coordinates are there
--         :cell_key             the mixed-radix integer of the coordinates
--         :outside              a coordinate lies outside the calibrated range
--         :read                 which channels are read
SELECT
  channel_id,
  support_id,
  time,
  CASE WHEN :is_present THEN :cell_key END AS cell_key,
  CASE WHEN :outside THEN 1 ELSE 0 END AS out_of_range,
  :span + position AS position,
  time AS context_time,
  0 AS doubled
FROM (
  SELECT
    channel_id,
    support_id,
    arraySlice(times, skipped + 1 + :span, vectors) AS time,
    :delayed
  FROM (
    SELECT
      channel_id,
      support_id,
      times,
      skipped,
      vectors,
      arrayMap(
        value -> assumeNotNull(:code),
        arrayMap(
          reading -> CASE WHEN NOT isNaN(reading) THEN reading END,
          arraySlice(samples, skipped + 1, vectors + :span)
        )
      ) AS codes
    FROM (
      SELECT
        channel_id,
        support_id,
        lo,
        hi,
        times,
        samples,
        skipped,
        greatest(arrayCount(time -> time <= :time_to, times) - skipped - :span, 0) AS vectors
      FROM (
        SELECT
          scale.channel_id AS channel_id,
          scale.support_id AS support_id,
          scale.lo AS lo,
          scale.hi AS hi,
          scale.taught_to AS taught_to,
          stored.times AS times,
          stored.samples AS samples,
          arrayCount(time -> time < :time_from, stored.times) AS skipped
        FROM stored
        JOIN scale ON scale.asset = stored.asset AND scale.channel = stored.channel
        WHERE :read
      ) AS begun
    ) AS counted
  ) AS coded
) AS embedded
ARRAY JOIN time, arrayEnumerate(time) AS position, :coordinates
