-- Parted: which versions a scheduled run reads, and by which of two reads of the source: 1 holds those that are read
-- from about as late on as the latest; 2 those from further back, and 3 those that no run has looked at, the second
-- read; 0 those that are parked. These lag behind the newest data by more than park_after, and were looked at within a
-- day; a look after now is of a clock that stood ahead.
-- Reads:  plan, clock
-- A row:  one version; a value from the instant look on says that a parked one sends again.
-- Slots:  :lookback  how late a row may come, in the unit of time
--         :since     by newest: who is read from before it lags
--         :day       microseconds of a day
--         :long_ago  an instant before all others
SELECT
  aged.version_id AS version_id,
  CASE
    WHEN aged.is_read = 0 THEN 3
    WHEN aged.read_from < aged.since
      THEN CASE WHEN aged.looked_at <= aged.started AND aged.started - aged.looked_at < :day THEN 0 ELSE 2 END
    WHEN aged.latest_from - aged.read_from - :lookback <= aged.newest - aged.latest_from THEN 1
    ELSE 2
  END AS part_no,
  CASE
    WHEN aged.read_until + 1 < aged.since
      THEN CASE WHEN aged.read_until + 1 > aged.read_from THEN aged.read_until + 1 ELSE aged.read_from END
    WHEN aged.since > aged.read_from THEN aged.since
    ELSE aged.read_from
  END AS look
FROM (
  SELECT
    version_id,
    read_from,
    read_until,
    looked_at,
    is_read,
    started,
    newest,
    since,
    MAX(CASE WHEN is_read = 1 AND read_from >= since THEN read_from END) OVER () AS latest_from
  FROM (
    SELECT version_id, read_from, read_until, looked_at, is_read, started, newest, :since AS since
    FROM (
      SELECT
        frozen.version_id AS version_id,
        frozen.read_from AS read_from,
        frozen.read_until AS read_until,
        frozen.looked_at AS looked_at,
        frozen.is_read AS is_read,
        watch.started AS started,
        CASE WHEN frozen.newest_read < watch.latest THEN frozen.newest_read ELSE watch.latest END AS newest
      FROM (
        SELECT
          version_id,
          read_from,
          read_until,
          looked_at,
          CASE WHEN looked_at > CAST(:long_ago AS BIGINT) THEN 1 ELSE 0 END AS is_read,
          MAX(
            CASE WHEN looked_at > CAST(:long_ago AS BIGINT) THEN read_until ELSE CAST(:long_ago AS BIGINT) END
          ) OVER () AS newest_read
        FROM plan
      ) AS frozen
      CROSS JOIN clock AS watch
    ) AS dated
  ) AS bounded
) AS aged
