-- Compared novel: the novel cells of the same buckets as in compared, stored and as the source gives them now.
-- Reads:  novel_cells, new_buckets, former_novel, cohort
-- A row:  one channel of which a cell differs; since is the beginning of the first such bucket.
SELECT
  missed.channel_id AS channel_id,
  MAX(missed.differing) AS differing,
  MIN(
    CASE WHEN made.hit = 1 AND made.first_time < missed.since THEN made.first_time ELSE missed.since END
  ) AS since
FROM (
  SELECT
    channel_id,
    CAST(COUNT(*) AS BIGINT) AS differing,
    MIN(bucket_no) AS first_bucket,
    MIN(first_time) AS since
  FROM (
    SELECT
      channel_id,
      bucket_no,
      cell_key,
      MIN(matched.first_time) AS first_time
    FROM (
      SELECT
        channel_id,
        bucket_no,
        cell_key,
        visits,
        first_time,
        last_time,
        CAST(SUM(is_stored) AS BIGINT) AS stored_rows,
        CAST(COUNT(*) AS BIGINT) AS both_rows
      FROM (
        SELECT
          cell.channel_id AS channel_id,
          cell.bucket_no AS bucket_no,
          cell.cell_key AS cell_key,
          cell.visits AS visits,
          cell.first_time AS first_time,
          cell.last_time AS last_time,
          1 AS is_stored
        FROM former_novel AS cell
        JOIN cohort AS member ON member.channel_id = cell.channel_id
        WHERE cell.bucket_no BETWEEN member.novel_from AND member.settled - 1
        UNION ALL
        SELECT
          strange.channel_id AS channel_id,
          strange.bucket_no AS bucket_no,
          strange.cell_key AS cell_key,
          strange.visits AS visits,
          strange.first_time AS first_time,
          strange.last_time AS last_time,
          0 AS is_stored
        FROM novel_cells AS strange
        JOIN cohort AS member ON member.channel_id = strange.channel_id
        WHERE strange.bucket_no BETWEEN member.novel_from AND member.settled - 1
          AND strange.last_time <= member.read_until
      ) AS both_sides
      GROUP BY channel_id, bucket_no, cell_key, visits, first_time, last_time
    ) AS matched
    WHERE both_rows <> 2 * stored_rows
    GROUP BY channel_id, bucket_no, cell_key
  ) AS cells
  GROUP BY channel_id
) AS missed
LEFT JOIN (
  SELECT channel_id, bucket_no, first_time, 1 AS hit
  FROM new_buckets
) AS made ON made.channel_id = missed.channel_id AND made.bucket_no = missed.first_bucket
GROUP BY missed.channel_id
