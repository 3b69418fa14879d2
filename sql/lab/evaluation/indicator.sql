-- Indicator: a table of health indicators, in the words of the evaluation (method, section 9).
-- Reads:  health, the relation that holds it.
-- A row:  one value of one channel, those that are NULL or no number included, as NULL.
-- Slots:  :asset, :channel     the names, as text
--         :place               integer that orders the values of a channel
--         :time                integer microseconds (UTC) or an integer counter
--         :hi                  the indicator
--         :novel_in_window     the count that it is a share of, NULL where it is none
--         :vectors_in_window   what it is a share of at each value, NULL where that is not told
--         :hi_limit            the limit of the channel at each value, NULL where the table has none
SELECT
  asset,
  channel,
  place,
  time,
  CASE
    WHEN raw_hi = CAST(0 AS DOUBLE) THEN CAST(0 AS DOUBLE)
    WHEN raw_hi BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN raw_hi
  END AS hi,
  novel_in_window,
  vectors_in_window,
  hi_limit
FROM (
  SELECT
    CAST(:asset AS VARCHAR) AS asset,
    CAST(:channel AS VARCHAR) AS channel,
    CAST(:place AS BIGINT) AS place,
    CAST(:time AS BIGINT) AS time,
    CAST(:hi AS DOUBLE) AS raw_hi,
    CAST(:novel_in_window AS BIGINT) AS novel_in_window,
    CAST(:vectors_in_window AS BIGINT) AS vectors_in_window,
    CAST(:hi_limit AS DOUBLE) AS hi_limit
  FROM health
) AS raw
