-- Probe rows: what the indicator would show if a machine changed, for each new support.
-- Reads:  probe, numbering
-- A row:  one change of one support; members of a pool share theirs.
SELECT
  numbered.stored_support_id AS support_id,
  asked.change_no AS change_no,
  asked.change_name AS change_name,
  asked.vectors AS vectors,
  asked.novel AS novel
FROM probe AS asked
JOIN numbering AS numbered ON numbered.channel_id = asked.support_id
