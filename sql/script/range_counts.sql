-- Range counts: how many samples of calibration lie in each piece of a range, and their extremes.
-- Reads:  history, range_before
-- Slots:  :piece  in which piece of a range a sample lies
SELECT
  asset,
  channel,
  allowed,
  piece,
  CAST(COUNT(*) AS BIGINT) AS samples,
  MIN(cut.value) AS lowest,
  MAX(cut.value) AS highest
FROM (
  SELECT asset, channel, allowed, value, CAST(:piece AS INTEGER) AS piece
  FROM (
    SELECT
      sampled.asset AS asset,
      sampled.channel AS channel,
      sampled.value AS value,
      whole.allowed AS allowed,
      whole.lo AS lo,
      whole.hi AS hi
    FROM history AS sampled
    JOIN range_before AS whole ON whole.asset = sampled.asset AND whole.channel = sampled.channel
    WHERE sampled.calibrating = 1 AND sampled.value BETWEEN whole.lo AND whole.hi
  ) AS ranged
) AS cut
GROUP BY asset, channel, allowed, piece
