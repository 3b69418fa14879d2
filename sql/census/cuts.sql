-- Cuts: the slices in which a declared interval begins or ends, between two of their samples, so that they hold samples
-- of calibration and others.
-- Reads:  slices, channels, declared
-- A row:  one slice of one channel.
SELECT DISTINCT named.channel_id AS channel_id, part.earliest AS first_time
FROM slices AS part
JOIN channels AS named ON named.asset = part.asset AND named.channel = part.channel
JOIN declared AS piece ON piece.calibration_no = named.calibration_no
WHERE
  (part.earliest < piece.time_from AND part.latest >= piece.time_from)
  OR (part.earliest <= piece.time_to AND part.latest > piece.time_to)
