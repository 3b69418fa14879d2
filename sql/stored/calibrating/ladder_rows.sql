-- Ladder rows: the floor on each grid of the ladder, of each new support.
-- Reads:  ladder, numbering
-- A row:  one grid of one support; members of a pool share theirs.
SELECT numbered.stored_support_id AS support_id, step.level_bins AS bins, step.floor AS floor
FROM ladder AS step
JOIN numbering AS numbered ON numbered.channel_id = step.support_id
