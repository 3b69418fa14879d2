-- Earliest: nothing older has to be read. Each channel has a bound of its own beside it; this one lets the
-- warehouse skip old partitions.
-- Reads:  cohort
-- A row:  the only one.
-- Slots:  :margin    taken off, since a timestamp without zone may be read in the zone of the session
--         :earliest  the first instant that a timestamp can be
SELECT
  CASE
    WHEN MIN(member.read_from) > CAST(:earliest AS BIGINT) THEN MIN(member.read_from) - :margin
    ELSE CAST(:earliest AS BIGINT)
  END AS read_from
FROM cohort AS member
