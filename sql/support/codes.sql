-- Codes: every sample of the channels to be embedded, coded (Phi, method section 3). A sample is
-- coded once and its code is delayed, not its value: all delays share one range.
-- Reads:  samples, bounds, run_up
-- A row:  one sample.
-- Slots:  :code  the expression of support/code.sql, cast to the narrowest integer that holds it
--         :read  which channels are read, by their run-up
SELECT channel_id, time, :code AS code
FROM (
  SELECT
    sampled.channel_id AS channel_id,
    sampled.time AS time,
    sampled.value AS value,
    scale.lo AS lo,
    scale.hi AS hi
  FROM samples AS sampled
  JOIN bounds AS scale ON scale.channel_id = sampled.channel_id
  JOIN run_up AS before ON before.channel_id = sampled.channel_id
  WHERE :read
) AS ranged
