-- Quarters: from when to when the beginnings of the quarters of a channel's head last, of which values are looked at.
-- Kept: SQLite would read all samples once for each row of it.
-- Reads:  granules
-- A row:  one quarter of one channel that holds a value at its beginning.
-- Slots:  :looked_at  the samples of a quarter that are looked at, a multiple of the largest granules
SELECT
  channel_id,
  quarter,
  MIN(granule.first_time) AS time_from,
  MAX(granule.last_time) AS time_to
FROM granules AS granule
WHERE (granule.granule_no + 1) * granule.size <= :looked_at
GROUP BY channel_id, quarter
