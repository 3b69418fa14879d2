-- Peaks: lags at which the signal is like itself again, after it was not in between. A trend or a random
-- walk forgets slowly and has none.
-- Reads:  correlations, scales
-- A row:  one such lag of one channel, as a period in samples.
SELECT
  lagged.channel_id AS channel_id,
  lagged.peak_lag * lagged.scale AS period,
  lagged.peak AS strength
FROM (
  SELECT
    apart.channel_id AS channel_id,
    apart.scale AS scale,
    rung.shortest AS shortest,
    apart.correlation AS after_peak,
    LAG(apart.lag_no, 1) OVER (PARTITION BY apart.channel_id, apart.scale ORDER BY apart.lag_no)
      AS peak_lag,
    LAG(apart.correlation, 1) OVER (PARTITION BY apart.channel_id, apart.scale ORDER BY apart.lag_no)
      AS peak,
    LAG(apart.correlation, 2) OVER (PARTITION BY apart.channel_id, apart.scale ORDER BY apart.lag_no)
      AS before_peak,
    MIN(apart.correlation) OVER (
      PARTITION BY apart.channel_id, apart.scale
      ORDER BY apart.lag_no
      ROWS BETWEEN UNBOUNDED PRECEDING AND 2 PRECEDING
    ) AS valley,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY apart.channel_id, apart.scale ORDER BY apart.lag_no) AS BIGINT
    ) AS row_no
  FROM correlations AS apart
  JOIN scales AS rung ON rung.scale = apart.scale
) AS lagged
WHERE lagged.row_no > 2
  AND lagged.peak_lag >= lagged.shortest
  AND lagged.peak > lagged.before_peak
  AND lagged.peak >= lagged.after_peak
  AND lagged.peak >= CAST(4e-1 AS DOUBLE)
  AND lagged.peak - lagged.valley >= CAST(2e-1 AS DOUBLE)
