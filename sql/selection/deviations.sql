-- Deviations: the standard deviation (ddof 0) of the scaled samples, by which the attractor's size is
-- judged. Squares are summed in whole units of 1 / FLOOR(2^62 / n): integers, the same in any order.
-- Reads:  selected, extents
-- A row:  one channel that has usable samples.
SELECT
  channel_id,
  SQRT(
    CAST(CAST(SUM(square_units) AS BIGINT) AS DOUBLE) / MIN(units) / CAST(COUNT(*) AS DOUBLE)
  ) AS deviation
FROM (
  SELECT
    channel_id,
    units,
    CAST(FLOOR(away * away * units + CAST(5e-1 AS DOUBLE)) AS BIGINT) AS square_units
  FROM (
    SELECT
      taken.channel_id AS channel_id,
      taken.scaled - extent.mean AS away,
      FLOOR(CAST(4611686018427387904 AS DOUBLE) / CAST(extent.usable AS DOUBLE)) AS units
    FROM selected AS taken
    JOIN extents AS extent ON extent.channel_id = taken.channel_id
    WHERE taken.scaled >= CAST(0 AS DOUBLE)
  ) AS centred
) AS squared
GROUP BY channel_id
