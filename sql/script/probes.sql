-- Probes: how many of the picked vectors each change would make novel.
-- Reads:  probe
SELECT asset, channel, change_no, change_name, vectors, novel
FROM probe
