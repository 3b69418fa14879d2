-- Novelty by a set: a(t) = 1 if the cell of v(t) is not in the support, else 0 (Eq. 4); as score/novelty, for
-- engines that look a row up in a set at less cost than they join (PostgreSQL, ClickHouse, SQLite). Proof: IN and
-- the join ask the same of the same rows; a set too large for PostgreSQL's memory is joined (most_in_set).
-- Reads:  monitored, support
-- A row:  one scored vector.
-- Slots:  :carried  columns that travel with the vector
--         :sought   the cell of a vector: census/set_key.sql, or support_id and cell_key
--         :cell     the same of the support
SELECT
  vector.channel_id AS channel_id,
  vector.time AS time,
  vector.cell_key AS cell_key,
  vector.out_of_range AS out_of_range,
  vector.position AS position,
  vector.context_time AS context_time,
  :carried,
  CASE
    WHEN :sought IN (SELECT :cell FROM support AS healthy) THEN 0
    ELSE 1
  END AS novel
FROM monitored AS vector
