-- Visited: where the machine was in each bucket: the novel cells one by one, all else in the row without a
-- cell. What buckets and novel cells need of the scored vectors is read off these few rows. A vector that
-- is neither novel nor the first or last of its bucket changes none of them, and is dropped before, and so are
-- samples of a run-up, whose number is none. A bucket has fewer than 2^31 vectors; narrow rows take less room.
-- Reads:  scored_vectors
-- A row:  one novel cell in one bucket, or NULL for its other vectors; closing = 1 if the bucket ends in it.
-- Slots:  :stride    vectors per bucket
--         :outside   whether a coordinate lies outside the calibrated range
--         :carried   columns that travel with the vector
--         :needed    what else makes a vector stay
--         :gathered  what is made of the carried columns
--         :cell, :part  the novel cell, by which rows are parted; or one of them, where it is asked alone how
--                    many vectors are novel: then rows are parted by whether they are
SELECT
  channel_id,
  bucket_no,
  :cell,
  CAST(COUNT(*) AS INTEGER) AS visits,
  MIN(visit.time) AS first_time,
  MAX(visit.time) AS last_time,
  CAST(SUM(visit.out_of_range) AS INTEGER) AS out_of_range,
  CAST(MAX(visit.closing) AS SMALLINT) AS closing,
  :gathered
FROM (
  SELECT
    channel_id,
    CAST(FLOOR((CAST(number AS DOUBLE) - CAST(5e-1 AS DOUBLE)) / CAST(:stride AS DOUBLE)) AS BIGINT)
      AS bucket_no,
    time,
    CASE WHEN novel = 1 THEN cell_key END AS novel_cell,
    :outside AS out_of_range,
    CASE WHEN number % :stride = 0 THEN 1 ELSE 0 END AS closing,
    :carried
  FROM scored_vectors
  WHERE (novel = 1 OR number % :stride <= 1) AND number > 0 OR :needed
) AS visit
GROUP BY channel_id, bucket_no, :part
