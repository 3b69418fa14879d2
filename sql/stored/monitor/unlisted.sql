-- Unlisted: versions whose settings no part of a script is for: their channels were calibrated otherwise since.
-- Reads:  plan
-- A row:  one version.
-- Slots:  :listed  the condition on frozen that a part is for it
SELECT frozen.version_id AS version_id
FROM plan AS frozen
WHERE CASE WHEN :listed THEN 0 ELSE 1 END = 1
