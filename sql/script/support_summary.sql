-- Support summary: what each channel has learnt, its verdict and its limit.
-- Reads:  channels, bounds, verdicts, vectors
-- Slots:  :dropped       what is told of samples outside the range
--         :verdict       the verdict of what was learnt
--         :learnt        what else was learnt
--         :hi_limit      the limit
--         :limit_reason  why there is none
--         :columns       those of the verdicts
SELECT
  named.asset AS asset,
  named.channel AS channel,
  scale.calibrated_lo AS calibrated_lo,
  scale.calibrated_hi AS calibrated_hi,
  :dropped,
  named.samples AS samples,
  scale.calibration_samples AS calibration_samples,
  CASE WHEN learnt.hit = 1 THEN learnt.vectors ELSE 0 END AS calibration_vectors,
  CASE WHEN learnt.hit = 1 THEN learnt.cells ELSE 0 END AS cells,
  CASE WHEN incomplete.hit = 1 THEN incomplete.missing_vectors ELSE 0 END AS missing_vectors,
  named.conflicts AS conflicts,
  CASE WHEN learnt.hit = 1 THEN :verdict ELSE 'no_data' END AS verdict,
  CASE WHEN learnt.hit = 1 THEN learnt.floor END AS floor,
  CASE WHEN learnt.hit = 1 THEN learnt.floor_sd END AS floor_sd,
  CASE WHEN learnt.hit = 1 THEN learnt.floor_max END AS floor_max,
  CASE WHEN learnt.hit = 1 THEN CAST(learnt.seen_once AS DOUBLE) / CAST(learnt.vectors AS DOUBLE) END
    AS good_turing,
  CASE WHEN learnt.hit = 1 THEN CAST(learnt.cells AS DOUBLE) / CAST(learnt.vectors AS DOUBLE) END
    AS cells_per_vector,
  CASE WHEN learnt.hit = 1 THEN learnt.blocks ELSE 0 END AS blocks,
  CASE WHEN learnt.hit = 1 THEN learnt.finest_bins END AS finest_bins,
  :learnt,
  CASE WHEN learnt.hit = 1 THEN :hi_limit END AS hi_limit,
  :limit_reason AS limit_reason
FROM channels AS named
JOIN bounds AS scale ON scale.asset = named.asset AND scale.channel = named.channel
LEFT JOIN (
  SELECT 1 AS hit, :columns
  FROM verdicts
) AS learnt ON learnt.asset = named.asset AND learnt.channel = named.channel
LEFT JOIN (
  SELECT asset, channel, CAST(COUNT(*) AS BIGINT) AS missing_vectors, 1 AS hit
  FROM vectors
  WHERE cell_key IS NULL
  GROUP BY asset, channel
) AS incomplete ON incomplete.asset = named.asset AND incomplete.channel = named.channel
