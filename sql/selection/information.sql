-- Information: average mutual information of a sample and the one some lag before it (Fraser and Swinney
-- 1986), in nats, with marginals from the same pairs: I = sum p(x,y) ln(p(x,y) / (p(x) p(y))). Each term
-- is put in whole units of 2^-24 before it is summed; the last bits of LN stay inside a unit but for
-- rare roundings. At lag 0 it is the entropy.
-- Reads:  pairs
-- A row:  one lag of one channel; occupied counts the pairs of bins that occur, now_bins and then_bins
--         those of each side.
SELECT
  channel_id,
  delay,
  MIN(all_pairs) AS n_pairs,
  CAST(COUNT(*) AS BIGINT) AS occupied,
  CAST(SUM(CASE WHEN opens_now = 1 THEN 1 ELSE 0 END) AS BIGINT) AS now_bins,
  CAST(SUM(CASE WHEN opens_then = 1 THEN 1 ELSE 0 END) AS BIGINT) AS then_bins,
  CAST(
    SUM(
      CAST(
        FLOOR(
          CAST(pairs AS DOUBLE) * LN(
            CAST(pairs AS DOUBLE) * CAST(all_pairs AS DOUBLE)
            / (CAST(pairs_now AS DOUBLE) * CAST(pairs_then AS DOUBLE))
          ) * CAST(16777216 AS DOUBLE) + CAST(5e-1 AS DOUBLE)
        ) AS BIGINT
      )
    ) AS BIGINT
  ) AS units
FROM (
  SELECT
    channel_id,
    delay,
    pairs,
    CAST(SUM(pairs) OVER (PARTITION BY channel_id, delay) AS BIGINT) AS all_pairs,
    CAST(SUM(pairs) OVER (PARTITION BY channel_id, delay, bin_now) AS BIGINT) AS pairs_now,
    CAST(SUM(pairs) OVER (PARTITION BY channel_id, delay, bin_then) AS BIGINT) AS pairs_then,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY channel_id, delay, bin_now ORDER BY bin_then) AS BIGINT
    ) AS opens_now,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY channel_id, delay, bin_then ORDER BY bin_now) AS BIGINT
    ) AS opens_then
  FROM pairs
) AS marginal
GROUP BY channel_id, delay
