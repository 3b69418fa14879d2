-- Scales: a ladder of lengths over which codes are summed before a cycle is looked for.
-- Repeated by Python, once per scale.
-- A row:  one scale.
-- Slots:  :scale     samples of a block
--         :shortest  the shortest lag, in blocks, at which a cycle is taken from this scale
SELECT CAST(:scale AS BIGINT) AS scale, CAST(:shortest AS BIGINT) AS shortest
