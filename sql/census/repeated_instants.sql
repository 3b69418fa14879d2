-- Repeated instants: the channels of which it was wrong to take it on trust that no instant occurs twice. What was
-- counted of them is of no use.
-- Reads:  marked, the step that shows it
-- A row:  one channel.
-- Slots:  :names  what says which one it is
SELECT DISTINCT :names
FROM marked
WHERE doubled = 1
