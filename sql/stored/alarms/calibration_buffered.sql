-- Calibration buffered: what alarms/buffered.sql counted at calibration.
-- Reads:  active, stored_buffered
-- A row:  one block of one channel, for one width.
SELECT
  member.channel_id AS channel_id,
  part.g AS g,
  part.block AS block,
  part.vectors AS vectors,
  part.novel_buffered AS novel_buffered
FROM stored_buffered AS part
JOIN active AS member ON member.version_id = part.version_id
