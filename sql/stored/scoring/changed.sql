-- Changed: from which bucket on a run writes what it has made: the first that is not stored just so, its novel cells
-- among it; else the one after the last. What is stored from there on is no more. Of a bucket with as many novel
-- vectors as before no cell is missing where each is there again.
-- Reads:  cohort, new_buckets, still_counts, novel_cells, former_buckets, former_novel
-- A row:  one channel; differs = 1 if there is such a bucket.
SELECT
  member.channel_id AS channel_id,
  member.version_id AS version_id,
  CASE WHEN difference.hit = 1 THEN difference.first_bucket ELSE member.first_bucket END AS first_bucket,
  CASE WHEN difference.hit = 1 THEN difference.differs ELSE 0 END AS differs
FROM cohort AS member
LEFT JOIN (
  SELECT
    channel_id,
    COALESCE(
      MIN(CASE WHEN new_rows <> former_rows THEN bucket_no END),
      MAX(bucket_no) + 1
    ) AS first_bucket,
    MAX(CASE WHEN new_rows <> former_rows THEN 1 ELSE 0 END) AS differs,
    1 AS hit
  FROM (
    SELECT
      channel_id,
      bucket_no,
      CAST(SUM(is_new) AS BIGINT) AS new_rows,
      CAST(SUM(1 - is_new) AS BIGINT) AS former_rows
    FROM (
      SELECT
        bucket.channel_id AS channel_id,
        bucket.bucket_no AS bucket_no,
        bucket.first_time AS first_time,
        bucket.last_time AS last_time,
        bucket.context_time AS context_time,
        bucket.samples AS samples,
        CASE WHEN calm.hit = 1 THEN calm.still END AS still,
        bucket.novel AS novel,
        bucket.out_of_range AS out_of_range,
        1 AS is_new
      FROM new_buckets AS bucket
      LEFT JOIN (
        SELECT channel_id, bucket_no, still, 1 AS hit
        FROM still_counts
      ) AS calm ON calm.channel_id = bucket.channel_id AND calm.bucket_no = bucket.bucket_no
      UNION ALL
      SELECT
        channel_id,
        bucket_no,
        first_time,
        last_time,
        context_time,
        samples,
        still,
        novel,
        out_of_range,
        0 AS is_new
      FROM former_buckets
    ) AS counted
    GROUP BY
      channel_id,
      bucket_no,
      first_time,
      last_time,
      context_time,
      samples,
      still,
      novel,
      out_of_range
    UNION ALL
    SELECT
      cell.channel_id AS channel_id,
      cell.bucket_no AS bucket_no,
      1 AS new_rows,
      CASE WHEN same.hit = 1 THEN 1 ELSE 0 END AS former_rows
    FROM (
      SELECT
        strange.channel_id AS channel_id,
        strange.bucket_no + member.first_bucket AS bucket_no,
        strange.cell_key AS cell_key,
        strange.visits AS visits,
        strange.first_time AS first_time,
        strange.last_time AS last_time
      FROM novel_cells AS strange
      JOIN cohort AS member ON member.channel_id = strange.channel_id
    ) AS cell
    LEFT JOIN (
      SELECT channel_id, bucket_no, cell_key, visits, first_time, last_time, 1 AS hit
      FROM former_novel
    ) AS same
      ON same.channel_id = cell.channel_id
      AND same.bucket_no = cell.bucket_no
      AND same.cell_key = cell.cell_key
      AND same.visits = cell.visits
      AND same.first_time = cell.first_time
      AND same.last_time = cell.last_time
  ) AS matched
  GROUP BY channel_id
) AS difference ON difference.channel_id = member.channel_id
