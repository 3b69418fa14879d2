-- Moved: the cells of vectors that are read again as they would be without each move (Phi, method section 3).
-- Reads:  reread, moves
-- A row:  one vector without one move; cell_key is NULL where a sample would be none.
-- Slots:  :samples     y_0, y_1, ... the samples without the move, each by stored/alarms/unmoved.sql
--         :codes       code_0, code_1, ... of them
--         :is_present  all of them are there
--         :cell_key    the mixed-radix integer of the codes
SELECT
  channel_id,
  support_id,
  window_no,
  move_no,
  factor,
  displacement,
  novel,
  CASE WHEN :is_present THEN CAST(:cell_key AS BIGINT) END AS cell_key
FROM (
  SELECT channel_id, support_id, window_no, move_no, factor, displacement, novel, :codes
  FROM (
    SELECT
      vector.channel_id AS channel_id,
      move.support_id AS support_id,
      vector.window_no AS window_no,
      move.move_no AS move_no,
      move.factor AS factor,
      move.displacement AS displacement,
      move.lo AS lo,
      move.hi AS hi,
      vector.novel AS novel,
      :samples
    FROM reread AS vector
    JOIN moves AS move ON move.channel_id = vector.channel_id AND move.window_no = vector.window_no
  ) AS undone
) AS coded
