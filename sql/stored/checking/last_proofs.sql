-- Last proofs: the newest check of each extent of a monitor that is no later than now.
-- Reads:  stored_proof
-- A row:  one check.
-- Slots:  :monitor_id
--         :now  a check after it was made by a clock that stood wrong
SELECT
  proof.extent AS extent,
  proof.proved_at AS proved_at,
  proof.channels AS channels,
  proof.versions AS versions,
  proof.buckets AS buckets,
  proof.differences AS differences
FROM stored_proof AS proof
JOIN (
  SELECT extent, MAX(earlier.proved_at) AS proved_at
  FROM stored_proof AS earlier
  WHERE earlier.monitor_id = :monitor_id AND earlier.proved_at <= :now
  GROUP BY extent
) AS latest ON latest.extent = proof.extent AND latest.proved_at = proof.proved_at
WHERE proof.monitor_id = :monitor_id
