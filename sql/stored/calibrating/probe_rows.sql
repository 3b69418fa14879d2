-- Probe rows: what the indicator would show if a machine changed, for each new support.
-- Reads:  probe, numbering
-- A row:  one change of one support; members of a pool share theirs.
SELECT
  numbered.stored_support_id AS support_id,
  outcome.change_no AS change_no,
  outcome.change_name AS change_name,
  outcome.vectors AS vectors,
  outcome.novel AS novel
FROM probe AS outcome
JOIN numbering AS numbered ON numbered.channel_id = outcome.support_id
