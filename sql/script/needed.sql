-- Needed: how many further vectors calibration needs, in whole windows.
-- Reads:  verdicts, outlook
-- Slots:  :columns  those of the verdicts
--         :bins     of the grid
--         :window   W, in vectors
SELECT
  learnt.asset AS asset,
  :columns,
  CAST(
    CASE
      WHEN learnt.finest_bins = :bins THEN 0
      WHEN ahead.hit = 1
        THEN 0 - :window * FLOOR(
          (CAST(ahead.vectors AS DOUBLE) - ahead.needed_total) / CAST(:window AS DOUBLE)
          + CAST(1 AS DOUBLE) / CAST(1048576 AS DOUBLE)
        )
    END AS BIGINT
  ) AS vectors_needed
FROM verdicts AS learnt
LEFT JOIN (
  SELECT asset, channel, vectors, needed_total, 1 AS hit
  FROM outlook
) AS ahead ON ahead.asset = learnt.asset AND ahead.channel = learnt.channel
