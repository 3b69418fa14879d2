-- Raised judgements: those of one version from one to another, with what they said.
-- Reads:  stored_visible_judgement
-- A row:  one judgement, in order.
-- Slots:  :version_id
--         :first, :last  numbers of judgements
SELECT
  judgement_no,
  first_time,
  last_time,
  novel,
  root,
  reference,
  height,
  evidence,
  is_open
FROM stored_visible_judgement
WHERE version_id = :version_id AND judgement_no >= :first AND judgement_no <= :last
ORDER BY judgement_no
