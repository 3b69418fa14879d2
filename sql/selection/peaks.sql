-- Peaks: where a series is like itself again: local maxima of the autocorrelation beyond its first zero,
-- seen at least five times in the data.
-- Reads:  autocorrelation, extents
-- A row:  one peak of one scale of one channel; delay in rows of that scale.
SELECT channel_id, scale, later_delay - 1 AS delay, acf_at AS acf
FROM (
  SELECT
    echo.channel_id AS channel_id,
    echo.scale AS scale,
    echo.delay AS later_delay,
    echo.acf AS acf_next,
    extent.samples AS samples,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY echo.channel_id, echo.scale ORDER BY echo.delay) AS BIGINT
    ) AS place,
    LAG(echo.acf, 1) OVER (PARTITION BY echo.channel_id, echo.scale ORDER BY echo.delay) AS acf_at,
    LAG(echo.acf, 2) OVER (PARTITION BY echo.channel_id, echo.scale ORDER BY echo.delay)
      AS acf_before,
    CAST(
      SUM(CASE WHEN echo.acf <= CAST(0 AS DOUBLE) THEN 1 ELSE 0 END) OVER (
        PARTITION BY echo.channel_id, echo.scale
        ORDER BY echo.delay
        ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS zeros
  FROM autocorrelation AS echo
  JOIN extents AS extent ON extent.channel_id = echo.channel_id
) AS lagging
WHERE place > 2
  AND zeros > 0
  AND acf_before < acf_at
  AND acf_at >= acf_next
  AND 5 * (later_delay - 1) * scale <= samples
