-- Framed counts: how many of the last W vectors are novel, of engines that take a moving frame lightly.
-- Reads:  novelty
-- Slots:  :before  W - 1
--         :window  W, in vectors
SELECT
  asset,
  channel,
  time,
  cell_key,
  novel,
  out_of_range,
  straddling,
  CAST(
    SUM(novel) OVER (
      PARTITION BY asset, channel ORDER BY time ROWS BETWEEN :before PRECEDING AND CURRENT ROW
    ) AS BIGINT
  ) AS novel_in_window,
  CAST(
    COUNT(*) OVER (
      PARTITION BY asset, channel ORDER BY time ROWS BETWEEN :before PRECEDING AND CURRENT ROW
    ) AS BIGINT
  ) AS vectors_in_window,
  :window AS window_length
FROM novelty
