-- Novel cells: where the machine went instead, cell by cell; what explains a raised indicator.
-- Reads:  numbered
-- A row:  one cell outside the support in one bucket.
-- Slots:  :stride  vectors per bucket
SELECT
  channel_id,
  bucket_no,
  cell_key,
  COUNT(*) AS visits,
  MIN(time) AS first_time,
  MAX(time) AS last_time
FROM (
  SELECT
    channel_id,
    time,
    cell_key,
    CAST(FLOOR((CAST(number AS DOUBLE) - CAST(5e-1 AS DOUBLE)) / CAST(:stride AS DOUBLE)) AS BIGINT)
      AS bucket_no
  FROM numbered
  WHERE novel = 1
) AS placed
GROUP BY channel_id, bucket_no, cell_key
