-- Cohorts: which channels of a run are read together, so that a silent one does not make every run read far back.
-- 0: those of today, whose time to read is at most twice that of the most recent one, and a lookback. 1: those
-- behind. 2: those from far back: new ones and, once a day, those that were silent for long. 3: these on other days,
-- of which only values are looked for that came after what was read, or are new enough.
-- Reads:  plan
-- A row:  one version; today_from is where a run begins to read that only looks at what is new.
-- Slots:  :chosen      a condition on frozen: the versions of the run
--         :lookback    how late a row may come, in the unit of time
--         :silence     a channel is silent whose data to read begins so long before the newest; NULL for never
--         :latest      the latest instant that counts
--         :started     when the run began, in microseconds
--         :day         a day, likewise
--         :everything  1 where silent channels are read on any day
--         :long_ago    an instant before all others
SELECT
  member.version_id AS version_id,
  CASE
    WHEN member.looked_at = CAST(:long_ago AS BIGINT) THEN 2
    WHEN member.read_from >= member.silent_before
      THEN CASE
        WHEN member.youngest - member.read_from <= member.newest - member.youngest + :lookback THEN 0
        ELSE 1
      END
    WHEN :everything = 1 OR member.looked_at > :started OR member.looked_at <= :started - :day THEN 2
    ELSE 3
  END AS cohort,
  CASE
    WHEN member.read_until + 1 < member.silent_before
      THEN CASE
        WHEN member.read_until < member.read_from THEN member.read_from
        ELSE member.read_until + 1
      END
    ELSE member.silent_before
  END AS look_from,
  member.newest - :lookback AS today_from
FROM (
  SELECT
    frozen.version_id AS version_id,
    frozen.read_from AS read_from,
    frozen.read_until AS read_until,
    frozen.looked_at AS looked_at,
    fleet.youngest AS youngest,
    fleet.newest AS newest,
    COALESCE(fleet.newest - CAST(:silence AS BIGINT), CAST(:long_ago AS BIGINT)) AS silent_before
  FROM plan AS frozen
  CROSS JOIN (
    SELECT
      COALESCE(MAX(read_range.read_from), CAST(:long_ago AS BIGINT)) AS youngest,
      CASE
        WHEN MAX(read_range.read_until) > :latest THEN CAST(:latest AS BIGINT)
        ELSE COALESCE(MAX(read_range.read_until), CAST(:long_ago AS BIGINT))
      END AS newest
    FROM (
      SELECT frozen.read_from AS read_from, frozen.read_until AS read_until
      FROM plan AS frozen
      WHERE frozen.looked_at > CAST(:long_ago AS BIGINT) AND :chosen
    ) AS read_range
  ) AS fleet
  WHERE :chosen
) AS member
