-- Moving codes: codes, where a sample that stands still counts as missing (alarms, section 1): it and the
-- still_after - 1 before it in its segment are all equal, and none of them is missing. It looks back only: since the
-- sample that is still_after - 1 before it, none has moved.
-- Reads:  codes
-- A row:  one sample; still = 1 where it stands still.
-- Slots:  :sample_columns  what is told of a sample by itself and the one before: the columns that are carried
--         :begins          whether a segment begins with the sample
--         :previous_value  of the sample before
--         :moved_at        when the newest sample that moved came
--         :held_from       the time of the sample still_after - 1 before
--         :carried         columns that travel with it
SELECT
  time,
  CASE WHEN moved_at <= held_from THEN 0 ELSE marked_code END AS code,
  CASE WHEN moved_at <= held_from THEN 1 ELSE 0 END AS still,
  :carried
FROM (
  SELECT time, marked_code, :carried, :moved_at AS moved_at, :held_from AS held_from
  FROM (
    SELECT
      time,
      code AS marked_code,
      :sample_columns,
      CASE WHEN :begins THEN 1 WHEN value = :previous_value THEN 0 ELSE 1 END AS moving
    FROM codes
  ) AS compared
) AS held
