-- Codes: the samples from the run-up on, coded (Phi, method section 3). A sample is coded once and its
-- code is delayed, not its value: all delays share one range.
-- Reads:  samples, run_up
-- A row:  one sample.
-- Slots:  :code     the expression of support/code.sql, cast to the narrowest integer that holds it
--         :read     which channels are read
--         :carried  columns that travel with the sample
--         :settings the settings of a channel that are read with its range; none where all channels share them
SELECT channel_id, time, :code AS code, :carried
FROM (
  SELECT
    sampled.channel_id AS channel_id,
    sampled.time AS time,
    sampled.value AS value,
    scale.lo AS lo,
    scale.hi AS hi,
    :settings
  FROM samples AS sampled
  JOIN run_up AS scale ON scale.channel_id = sampled.channel_id
  WHERE sampled.time >= scale.read_from AND :read
) AS ranged
