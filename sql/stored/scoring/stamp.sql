-- Stamp: the number and the times of a run.
-- A row:  the only one; deletes_hidden is 1 where the commit takes away what the run replaces,
--         episodes_pending where episodes are left to the next run.
-- Slots:  :run_id
--         :started         when the run began, in microseconds
--         :committed       when its rows are written, likewise
--         :deletes_hidden
SELECT
  CAST(:run_id AS BIGINT) AS run_id,
  CAST(:started AS BIGINT) AS started,
  CAST(:committed AS BIGINT) AS committed,
  CAST(:deletes_hidden AS BIGINT) AS deletes_hidden,
  CAST(NULL AS BIGINT) AS episodes_pending
