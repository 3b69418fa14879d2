-- Lag sums: what a correlation at a lag is made of, as integers, quarter by quarter.
-- Reads:  block_sums
-- A row:  one lag, in blocks, of one quarter of one channel at one scale; covariance and variances are
--         times the square of the pairs.
-- Slots:  :longest_lag  in blocks
SELECT
  summed.channel_id AS channel_id,
  summed.scale AS scale,
  summed.lag_no AS lag_no,
  summed.pairs AS pairs,
  summed.pairs * summed.products - summed.early_sum * summed.late_sum AS covariance,
  summed.pairs * summed.early_squares - summed.early_sum * summed.early_sum AS early_variance,
  summed.pairs * summed.late_squares - summed.late_sum * summed.late_sum AS late_variance
FROM (
  SELECT
    paired.channel_id AS channel_id,
    paired.scale AS scale,
    paired.quarter AS quarter,
    paired.lag_no AS lag_no,
    CAST(COUNT(*) AS BIGINT) AS pairs,
    CAST(SUM(paired.early_code) AS BIGINT) AS early_sum,
    CAST(SUM(paired.late_code) AS BIGINT) AS late_sum,
    CAST(SUM(paired.early_code * paired.late_code) AS BIGINT) AS products,
    CAST(SUM(paired.early_code * paired.early_code) AS BIGINT) AS early_squares,
    CAST(SUM(paired.late_code * paired.late_code) AS BIGINT) AS late_squares
  FROM (
    SELECT
      early.channel_id AS channel_id,
      early.scale AS scale,
      early.quarter AS quarter,
      late.block_no - early.block_no AS lag_no,
      early.code_sum AS early_code,
      late.code_sum AS late_code
    FROM block_sums AS early
    JOIN block_sums AS late
      ON late.channel_id = early.channel_id
      AND late.scale = early.scale
      AND late.quarter = early.quarter
      AND late.block_no > early.block_no
      AND late.block_no - early.block_no <= :longest_lag
  ) AS paired
  GROUP BY paired.channel_id, paired.scale, paired.quarter, paired.lag_no
) AS summed
