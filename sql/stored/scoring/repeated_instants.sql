-- Repeated instants: the channels of which it was wrong to take it on trust that no instant occurs twice. What was
-- counted of them is of no use.
-- Reads:  visited
-- A row:  one channel.
SELECT DISTINCT channel_id
FROM visited
WHERE doubled = 1
