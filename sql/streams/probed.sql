-- Probed, one channel: its picked vectors, each with the samples that it would hold if the machine were slower, faster or
-- as it is; as probe/probed.sql. For DuckDB, by streams/vectors.sql. Proof: that of streams/visits.sql, of the same rows.
-- Reads:  streamed, block_sizes
-- A row:  one picked vector; a sample is NULL where there is no such.
-- Slots:  :counted  whether a sample ends a vector that counts
--         :number   the number of the vector, from 1
--         :block_no  the expression of certificate/block_no.sql, of place
--         :picked   the expression of probe/is_picked.sql
--         :samples  x_0, x_1, ...
--         :channel_id, :support_id
--         :taught, :before  how many vectors taught its support, and those of members before it
SELECT
  CAST(:support_id AS BIGINT) AS support_id,
  vector.number AS number,
  size.pool_block AS block,
  :samples
FROM (
  SELECT number, block_no, :samples
  FROM (
    SELECT
      place + CAST(:before AS BIGINT) AS number,
      CAST(:taught AS BIGINT) AS vectors,
      CAST(:block_no AS BIGINT) AS block_no,
      :samples
    FROM (
      SELECT :number - 1 AS place, :samples
      FROM streamed
      WHERE :counted
    ) AS learnable
  ) AS numbered
  WHERE :picked
) AS vector
JOIN block_sizes AS size ON size.channel_id = :channel_id AND size.block_no = vector.block_no
