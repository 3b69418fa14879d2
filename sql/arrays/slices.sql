-- Slices, of arrays: what each channel holds, piece by piece; as census/slices.sql, cut by the number of samples: a
-- piece has as many as there are pieces. For ClickHouse, which has the samples in arrays already, and need not group
-- rows again. Proof: stored, whose arrays hold every sample once, in order.
-- Dialect: clickhouse
-- Reads:  stored
-- A row:  one piece of one (asset, channel) pair; rows without a time are counted in the first one.
SELECT
  asset,
  channel,
  CAST(slice_no AS BIGINT) AS slice_no,
  CAST(length(piece) AS BIGINT) - CASE WHEN slice_no = 1 THEN without_time ELSE 0 END AS readings,
  CASE WHEN slice_no = 1 THEN without_time ELSE 0 END AS without_time,
  CAST(length(piece) - length(present) AS BIGINT) AS missing_readings,
  arrayReduce('minOrNull', present) AS lowest,
  arrayReduce('maxOrNull', present) AS highest,
  piece[1] AS earliest,
  piece[-1] AS latest
FROM (
  SELECT
    asset,
    channel,
    without_time,
    slice_no,
    piece,
    arrayFilter(value -> NOT isNaN(value), sampled) AS present
  FROM (
    SELECT
      asset,
      channel,
      without_time,
      arraySplit((time, place) -> (place - 1) % width = 0, times, arrayEnumerate(times)) AS pieces,
      arraySplit((value, place) -> (place - 1) % width = 0, samples, arrayEnumerate(times)) AS pieces_sampled
    FROM (
      SELECT
        asset,
        channel,
        without_time,
        times,
        samples,
        CAST(ceil(sqrt(length(times))) AS INTEGER) AS width
      FROM stored
    ) AS measured
  ) AS cut
  ARRAY JOIN pieces AS piece, pieces_sampled AS sampled, arrayEnumerate(pieces) AS slice_no
) AS joined
