-- Conflicts, where each instant occurs once: none.
-- Reads:  channels
-- A row:  one channel.
SELECT channel_id, CAST(0 AS BIGINT) AS conflicts
FROM channels
