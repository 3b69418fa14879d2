-- Spread: the floor of each channel on its grid.
-- Reads:  floors
SELECT asset, channel, vectors, blocks, floors.floor AS floor, floors.floor_max AS floor_max
FROM floors
WHERE level = 0
