-- Coded, in order: all samples of the channels with a range, coded (Phi, method section 3), one after another, so
-- that the number of a row (rowid) is its place. For SQLite, where a window costs as much as all else: a delay is
-- then a row some numbers before. CROSS JOIN keeps it to this order, in which pieces and their readings lie.
-- Proof: the step runs.
-- Dialect: sqlite
-- Reads:  pieces, scale, lined
-- A row:  one sample, kept.
-- Slots:  :code  the expression of support/code.sql, cast to the narrowest integer that holds it
SELECT channel_id, time, :code AS code
FROM (
  SELECT
    scale.channel_id AS channel_id,
    reading.time AS time,
    reading.value AS value,
    scale.lo AS lo,
    scale.hi AS hi
  FROM pieces AS part
  CROSS JOIN scale ON scale.asset = part.asset AND scale.channel = part.channel
  CROSS JOIN lined AS reading ON reading.rowid BETWEEN part.first_row AND part.last_row
  WHERE reading.time IS NOT NULL
) AS ranged
