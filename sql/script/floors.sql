-- Floors: what share of vectors is novel in healthy operation, on each grid, and how it spreads.
-- Reads:  shares
SELECT
  asset,
  channel,
  level,
  level_bins,
  CAST(COUNT(*) AS BIGINT) AS blocks,
  CAST(SUM(share.vectors) AS BIGINT) AS vectors,
  MIN(share.floor) AS floor,
  MAX(healthy_hi) AS floor_max,
  SQRT(
    CAST(
      CAST(
        SUM(
          CAST(
            FLOOR(
              (healthy_hi - share.floor) * (healthy_hi - share.floor) * units + CAST(5e-1 AS DOUBLE)
            ) AS BIGINT
          )
        ) AS BIGINT
      ) AS DOUBLE
    ) / MIN(units) / NULLIF(COUNT(*) - 1, 0)
  ) AS floor_sd
FROM shares AS share
GROUP BY asset, channel, level, level_bins
