-- Ordered: names, and whether each channel's rows lie together and each is later than the one before. For
-- engines that hand out rows as they are stored, and number them so where a window has no order (DuckDB).
-- Reads:  readings
-- A row:  one (asset, channel) pair; in_order = 1 if that holds of it.
SELECT
  asset,
  channel,
  CAST(SUM(CASE WHEN time IS NULL THEN 0 ELSE 1 END) AS BIGINT) AS readings,
  CAST(SUM(CASE WHEN time IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS without_time,
  CAST(
    SUM(
      CASE
        WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN 0
        ELSE 1
      END
    ) AS BIGINT
  ) AS missing_readings,
  MIN(numbered.time) AS earliest,
  MAX(numbered.time) AS latest,
  CASE
    WHEN MAX(place) - MIN(place) + 1 = CAST(COUNT(*) AS BIGINT)
      AND MAX(CASE WHEN numbered.time > previous_time THEN 0 ELSE place END) <= MIN(place) THEN 1
    ELSE 0
  END AS in_order
FROM (
  SELECT
    asset,
    channel,
    time,
    reading,
    LAG(time, 1) OVER () AS previous_time,
    CAST(ROW_NUMBER() OVER () AS BIGINT) AS place
  FROM readings
) AS numbered
GROUP BY asset, channel
