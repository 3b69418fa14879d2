-- Blocks: the certificate of one signal, block by block.
-- Reads:  stored_block
-- A row:  one block of calibration, judged by the others.
-- Slots:  :support_id, :channel_id  what was learnt, and of which signal
SELECT block, first_time, last_time, vectors, novel
FROM stored_block
WHERE support_id = :support_id AND channel_id = :channel_id
ORDER BY block
