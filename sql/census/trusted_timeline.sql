-- Trusted timeline: the timeline of channels of which it is taken on trust that no instant occurs twice. What has the
-- vectors in hand tells of which ones it was wrong to: the step repeated_instants, or the proof of a stream.
-- Reads:  cohort
-- A row:  one channel.
SELECT member.channel_id AS channel_id, CAST(0 AS BIGINT) AS repeats
FROM cohort AS member
