-- Next judgement: the number of the judgement after those of a version.
-- Reads:  stored_visible_judgement
-- A row:  the only one; NULL where nothing is judged yet.
-- Slots:  :version_id
SELECT MAX(judgement_no) + 1 AS next_no
FROM stored_visible_judgement
WHERE version_id = :version_id
