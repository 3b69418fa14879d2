-- Proof rows: what records that all checksums were verified.
-- Reads:  proof_due, active
-- A row:  the only one, if it was due.
-- Slots:  :monitor_id
SELECT
  CAST(:monitor_id AS BIGINT) AS monitor_id,
  due.proved_at AS proved_at,
  'checksums' AS extent,
  counted.versions AS channels,
  counted.versions AS versions,
  CAST(0 AS BIGINT) AS buckets,
  CAST(0 AS BIGINT) AS differences
FROM proof_due AS due
CROSS JOIN (
  SELECT CAST(COUNT(*) AS BIGINT) AS versions
  FROM active
) AS counted
