-- Learned: what each block of calibration adds: cells that none before it visits, and their share of it.
-- Reads:  cell_shares
SELECT asset, channel, block, CAST(1 AS BIGINT) AS new_cells, share_units
FROM cell_shares
UNION ALL
SELECT asset, channel, second_block AS block, CAST(0 AS BIGINT) AS new_cells, 0 - part.share_units AS share_units
FROM cell_shares AS part
WHERE second_block IS NOT NULL
