-- Range counts, of arrays: the calibration samples of each support in 128 equal pieces of the range that is left; as
-- range/range_counts.sql. For ClickHouse, which has the samples in arrays already. Proof: stored, whose arrays hold every
-- sample once.
-- Dialect: clickhouse
-- Reads:  stored, calibration, channels, range_before
-- A row:  one piece of one support that holds samples.
-- Slots:  :piece  the expression of range/piece.sql
SELECT
  support_id,
  allowed,
  piece,
  CAST(COUNT(*) AS BIGINT) AS samples,
  MIN(cut.value) AS lowest,
  MAX(cut.value) AS highest
FROM (
  SELECT support_id, allowed, value, CAST(:piece AS INTEGER) AS piece
  FROM (
    SELECT support_id, allowed, lo, hi, value
    FROM (
      SELECT
        whole.support_id AS support_id,
        whole.allowed AS allowed,
        whole.lo AS lo,
        whole.hi AS hi,
        arrayFilter(
          (value, time) -> time BETWEEN healthy.time_from AND healthy.time_to AND value BETWEEN whole.lo AND whole.hi,
          stored.samples,
          stored.times
        ) AS held
      FROM stored
      JOIN channels AS named ON named.asset = stored.asset AND named.channel = stored.channel
      JOIN calibration AS healthy ON healthy.channel_id = named.channel_id
      JOIN range_before AS whole ON whole.support_id = named.support_id
    ) AS gathered
    ARRAY JOIN held AS value
  ) AS ranged
) AS cut
GROUP BY support_id, allowed, piece
