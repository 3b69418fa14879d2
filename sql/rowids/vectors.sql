-- Vectors by row: v(t) (Eq. 1) of coded samples, whose rows are numbered in order: a delay is the row so many
-- before, and no window is needed. For SQLite; CROSS JOIN keeps it to this order. Proof: pieces and runs, so that no
-- vector need be marked.
-- Dialect: sqlite
-- Reads:  runs, coded
-- A row:  one vector, at the time of its newest sample; cell_key is NULL where a sample is missing; position
--         counts the samples from the first one that is read.
-- Slots:  :first_row, :last_row  the rows of a channel that are read
--         :span                  (m-1) * tau, the samples between oldest and newest
--         :delayed               code_1 ... code_(m-1), of rows that Python joins by rowids/delayed.sql
--         :is_present            all coordinates are there
--         :cell_key              the mixed-radix integer of the coordinates
--         :outside               a coordinate lies outside the calibrated range
--         :read                  which channels are read
SELECT
  channel_id,
  support_id,
  time,
  CASE WHEN :is_present THEN :cell_key END AS cell_key,
  CASE WHEN :outside THEN 1 ELSE 0 END AS out_of_range,
  position,
  time AS context_time,
  0 AS doubled
FROM (
  SELECT
    run.channel_id AS channel_id,
    run.support_id AS support_id,
    newest.time AS time,
    newest.code AS code_0,
    :delayed,
    newest.rowid - :first_row + 1 AS position
  FROM runs AS run
  CROSS JOIN coded AS newest ON newest.rowid BETWEEN :first_row + :span AND :last_row
  WHERE :read
) AS embedded
