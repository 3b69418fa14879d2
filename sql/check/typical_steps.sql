-- Typical steps: the lower median of the steps in time, and the steps that 5 % are no longer and 5 % no
-- shorter than. The first length whose rank reaches the share is the one; nothing is interpolated.
-- Reads:  step_ranks
-- A row:  one channel with at least two samples.
SELECT
  channel_id,
  MAX(steps_in_all) AS steps,
  MIN(CASE WHEN 2 * steps_up_to >= steps_in_all THEN step END) AS typical_step,
  MIN(CASE WHEN 20 * steps_up_to >= steps_in_all THEN step END) AS short_step,
  MIN(CASE WHEN 20 * steps_up_to >= 19 * steps_in_all THEN step END) AS long_step
FROM step_ranks
GROUP BY channel_id
