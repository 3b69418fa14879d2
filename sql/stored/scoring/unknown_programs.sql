-- Unknown programs: the readings of a channel whose program is not judged, after the end of the bucket before, up to the
-- end of each; those of the bucket after the last full one came since.
-- Reads:  judged_samples, buckets, cohort
-- A row:  one program in one bucket, numbered on from those that stay; program is NULL where none was told.
SELECT
  member.channel_id AS channel_id,
  member.version_id AS version_id,
  counted.buckets_before + member.first_bucket AS bucket_no,
  counted.program AS program,
  counted.readings AS readings,
  counted.first_time AS first_time,
  counted.last_time AS last_time
FROM (
  SELECT
    channel_id,
    buckets_before,
    program,
    CAST(SUM(ordered.is_reading) AS BIGINT) AS readings,
    MIN(ordered.time) AS first_time,
    MAX(ordered.time) AS last_time
  FROM (
    SELECT
      channel_id,
      time,
      program,
      is_reading,
      CAST(
        SUM(1 - is_reading) OVER (
          PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS buckets_before
    FROM (
      SELECT sampled.channel_id AS channel_id, sampled.time AS time, sampled.program AS program, 1 AS is_reading
      FROM judged_samples AS sampled
      JOIN cohort AS scored ON scored.channel_id = sampled.channel_id
      WHERE sampled.program_no IS NULL AND sampled.value IS NOT NULL AND sampled.time >= scored.first_scored
      UNION ALL
      SELECT
        ended.channel_id AS channel_id,
        ended.last_time AS time,
        CAST(NULL AS VARCHAR) AS program,
        0 AS is_reading
      FROM buckets AS ended
    ) AS mixed
  ) AS ordered
  WHERE is_reading = 1
  GROUP BY channel_id, buckets_before, program
) AS counted
JOIN cohort AS member ON member.channel_id = counted.channel_id
