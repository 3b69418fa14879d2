-- Scored vectors, in stored order: those of one channel with number and novelty (Eq. 4). For DuckDB, by
-- streams/vectors.sql: rows are numbered as they come, and cells looked up in the bits of one support. Proof: no row
-- has doubled = 1, so that rows came by time.
-- Reads:  support_bits, streamed, the samples of the channel from its run-up on
-- A row:  one scored vector, or a sample that is kept beside them, whose number is none; doubled = 1 if it is not
--         later than the one before.
-- Slots:  :channel_id, :support_id
--         :counted  which samples are kept
--         :number   the number of the scored vector, from 1
--         :is_held  1 if the cell of the vector is in the support's bits; NULL of an empty support
--         :carried  code_0 ... code_(m-1)
SELECT
  CAST(:channel_id AS INTEGER) AS channel_id,
  time,
  number,
  cell_key,
  CASE WHEN :is_held = 1 THEN 0 ELSE 1 END AS novel,
  :carried,
  out_of_order AS doubled
FROM (
  SELECT time, :number AS number, cell_key, :carried, out_of_order
  FROM streamed
  WHERE :counted OR out_of_order = 1
) AS numbered
CROSS JOIN (
  SELECT ANY_VALUE(held.bits) AS bits
  FROM support_bits AS held
  WHERE support_id = :support_id
) AS healthy
