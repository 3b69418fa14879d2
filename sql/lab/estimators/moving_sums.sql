-- Moving sums: the sum of Eq. 2 over the last W scored vectors: what the block of W at hand has so far,
-- and what the one before still had to come W vectors ago. A running sum never exceeds one window.
-- Reads:  score_units
-- A row:  one scored vector; units_in_window is NULL until W vectors were scored.
-- Slots:  :window  W, in vectors
--         :stride  vectors per bucket
SELECT
  channel_id,
  time,
  score,
  number,
  CASE
    WHEN number > :window THEN units_so_far + units_left
    WHEN number = :window THEN units_so_far
  END AS units_in_window,
  :window AS window_length,
  :stride AS bucket_length
FROM (
  SELECT
    channel_id,
    time,
    score,
    number,
    units_so_far,
    LAG(block_units - units_so_far, :window) OVER (PARTITION BY channel_id ORDER BY time) AS units_left
  FROM (
    SELECT
      channel_id,
      time,
      score,
      number,
      CAST(
        SUM(units) OVER (
          PARTITION BY channel_id, block_no
          ORDER BY time
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS units_so_far,
      CAST(SUM(units) OVER (PARTITION BY channel_id, block_no) AS BIGINT) AS block_units
    FROM score_units
  ) AS running
) AS lagged
