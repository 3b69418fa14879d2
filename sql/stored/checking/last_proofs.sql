-- Last proofs: the newest check of each extent of a monitor that is no later than now.
-- Reads:  stored_proof
-- A row:  one check.
-- Slots:  :monitor_id
--         :now  a check after it was made by a clock that stood wrong
SELECT
  made.extent AS extent,
  made.proved_at AS proved_at,
  made.channels AS channels,
  made.versions AS versions,
  made.buckets AS buckets,
  made.differences AS differences
FROM stored_proof AS made
JOIN (
  SELECT extent, MAX(earlier.proved_at) AS proved_at
  FROM stored_proof AS earlier
  WHERE earlier.monitor_id = :monitor_id AND earlier.proved_at <= :now
  GROUP BY extent
) AS latest ON latest.extent = made.extent AND latest.proved_at = made.proved_at
WHERE made.monitor_id = :monitor_id
