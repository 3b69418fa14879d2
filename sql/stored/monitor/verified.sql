-- Verified: the versions whose checksum a scheduled run verifies: those that it scores by, and once a day all.
-- Reads:  cohort, active, proof_due
-- A row:  one version.
SELECT member.version_id AS version_id
FROM cohort AS member
UNION
SELECT frozen.version_id AS version_id
FROM active AS frozen
CROSS JOIN proof_due
