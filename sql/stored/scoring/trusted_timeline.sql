-- Trusted timeline: the timeline of channels of which it is taken on trust that no instant occurs twice. The step
-- repeated_instants tells afterwards of which ones it was wrong to.
-- Reads:  cohort
-- A row:  one channel.
SELECT member.channel_id AS channel_id, CAST(0 AS BIGINT) AS repeats
FROM cohort AS member
