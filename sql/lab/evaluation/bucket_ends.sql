-- Bucket ends: of an indicator that is there for every vector, the values at the end of each bucket of so
-- many vectors, as gam run --every stride writes them.
-- Reads:  raw_indicator
-- A row:  one value of one channel, with the columns of indicator; what cannot be numbered, and
--         instants that are there twice, stay, so that they can be refused.
-- Slots:  :stride  vectors of a bucket
SELECT asset, channel, place, time, hi, novel_in_window, vectors_in_window, hi_limit
FROM (
  SELECT
    asset,
    channel,
    place,
    time,
    hi,
    novel_in_window,
    vectors_in_window,
    hi_limit,
    CAST(ROW_NUMBER() OVER (PARTITION BY asset, channel ORDER BY place) AS BIGINT) AS number,
    LAG(place, 1) OVER (PARTITION BY asset, channel ORDER BY place) AS place_before,
    LAG(place, 1) OVER (PARTITION BY asset, channel ORDER BY place DESC) AS place_after
  FROM raw_indicator
) AS numbered
WHERE number % :stride = 0
  OR place = place_before
  OR place = place_after
  OR place IS NULL
  OR asset IS NULL
  OR channel IS NULL
