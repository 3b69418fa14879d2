-- Met range: between which instants the slices of all channels lie that a range of time meets.
-- Reads:  edges
-- A row:  the only one.
-- Slots:  :first, :last  the range
SELECT MIN(part.first_time) AS first_time, MAX(part.last_time) AS last_time
FROM edges AS part
WHERE part.last_time >= :first AND part.first_time <= :last
