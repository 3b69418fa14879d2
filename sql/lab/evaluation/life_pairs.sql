-- Life pairs: how alike two failed series are over their lives: the size of Pearson's correlation of
-- their points, NULL where one of them is constant.
-- Reads:  life_points
-- A row:  one pair of series of different assets.
SELECT
  asset_no,
  other_no,
  ABS(
    (
      CAST(product_sum AS DOUBLE)
      - (CAST(level_sum AS DOUBLE) * CAST(other_sum AS DOUBLE) / CAST(points AS DOUBLE))
    )
    / NULLIF(
      SQRT(
        (
          CAST(level_square_sum AS DOUBLE)
          - (CAST(level_sum AS DOUBLE) * CAST(level_sum AS DOUBLE) / CAST(points AS DOUBLE))
        )
        * (
          CAST(other_square_sum AS DOUBLE)
          - (CAST(other_sum AS DOUBLE) * CAST(other_sum AS DOUBLE) / CAST(points AS DOUBLE))
        )
      ),
      CAST(0 AS DOUBLE)
    )
  ) AS likeness
FROM (
  SELECT
    series.asset_no AS asset_no,
    other.asset_no AS other_no,
    MAX(series.points) AS points,
    CAST(SUM(series.level) AS BIGINT) AS level_sum,
    CAST(SUM(other.level) AS BIGINT) AS other_sum,
    CAST(SUM(series.level * other.level) AS BIGINT) AS product_sum,
    CAST(SUM(series.level * series.level) AS BIGINT) AS level_square_sum,
    CAST(SUM(other.level * other.level) AS BIGINT) AS other_square_sum
  FROM life_points AS series
  JOIN life_points AS other ON other.point_no = series.point_no
  WHERE series.series_id < other.series_id AND series.asset_no <> other.asset_no
  GROUP BY series.series_id, other.series_id, series.asset_no, other.asset_no
) AS paired
