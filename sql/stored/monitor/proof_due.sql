-- Proof due: whether the checksums of all active versions are to be verified: within a day nobody has.
-- Reads:  clock, stored_monitor, stored_proof
-- A row:  the only one, if so.
-- Slots:  :monitor_id
--         :day         microseconds of a day
SELECT watch.started AS proved_at
FROM clock AS watch
CROSS JOIN (
  SELECT MAX(last.start_time) AS start_time
  FROM (
    SELECT watched.created AS start_time
    FROM stored_monitor AS watched
    CROSS JOIN clock AS begun
    WHERE watched.monitor_id = :monitor_id AND watched.created <= begun.started
    UNION ALL
    SELECT proof.proved_at AS start_time
    FROM stored_proof AS proof
    CROSS JOIN clock AS begun
    WHERE proof.monitor_id = :monitor_id AND proof.differences = 0 AND proof.proved_at <= begun.started
  ) AS last
) AS latest
WHERE CASE WHEN watch.started - latest.start_time < :day THEN 0 ELSE 1 END = 1
