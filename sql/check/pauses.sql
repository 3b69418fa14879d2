-- Pauses: steps in time beyond a multiple of the typical one. A max_gap between the longest step that is
-- none and the shortest pause tells them apart. Compared as doubles: five steps may pass 64 bits.
-- Reads:  step_counts, typical_steps
-- A row:  one channel with at least two samples.
-- Slots:  :pause  how many typical steps are no pause yet
SELECT
  judged.channel_id AS channel_id,
  MAX(judged.typical_step) AS typical_step,
  MAX(judged.short_step) AS short_step,
  MAX(judged.long_step) AS long_step,
  CAST(SUM(judged.is_pause * judged.occurrences) AS BIGINT) AS pauses,
  CAST(SUM(CASE WHEN judged.step = judged.typical_step THEN judged.occurrences ELSE 0 END) AS BIGINT)
    AS typical_steps,
  MAX(CASE WHEN judged.is_pause = 0 THEN judged.step END) AS longest_step,
  MIN(CASE WHEN judged.is_pause = 1 THEN judged.step END) AS shortest_pause,
  MAX(CASE WHEN judged.is_pause = 1 THEN judged.step END) AS longest_pause
FROM (
  SELECT
    spaced.channel_id AS channel_id,
    spaced.step AS step,
    spaced.occurrences AS occurrences,
    usual.typical_step AS typical_step,
    usual.short_step AS short_step,
    usual.long_step AS long_step,
    CAST(
      CASE
        WHEN CAST(spaced.step AS DOUBLE)
          > CAST(usual.typical_step AS DOUBLE) * CAST(:pause AS DOUBLE) THEN 1
        ELSE 0
      END AS BIGINT
    ) AS is_pause
  FROM step_counts AS spaced
  JOIN typical_steps AS usual ON usual.channel_id = spaced.channel_id
  WHERE spaced.step > 0
) AS judged
GROUP BY judged.channel_id
