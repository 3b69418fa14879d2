-- Run-up, stored form: from where on a channel is read, and whether a vector's number follows from its
-- position: no sample is missing, and none precedes the first vector but those that it holds.
-- Reads:  cohort, seen
-- A row:  one channel that has a sample in its range.
-- Slots:  :span      (m-1) * tau, the samples between oldest and newest
--         :settings  the settings of a channel that its steps read; none where all channels share them
SELECT
  member.channel_id AS channel_id,
  member.lo AS lo,
  member.hi AS hi,
  member.read_from AS read_from,
  ranged.context_rows AS context_rows,
  CASE WHEN ranged.missing_samples = 0 AND ranged.context_rows <= :span THEN 1 ELSE 0 END AS complete,
  :settings
FROM cohort AS member
JOIN seen AS ranged ON ranged.channel_id = member.channel_id
