-- Orphans: rows that belong to nothing, since what they name is not there, and keys that are there twice. A run
-- that was cut short leaves rows behind without a record where there are no transactions, and a calibration
-- likewise; so there only rows count whose run is recorded for other versions.
-- Reads:  stored_monitor, stored_channel, stored_version, stored_calibration, stored_checksum, stored_bounds,
--         stored_block, stored_support, stored_bucket, stored_novel, stored_horizon, stored_run, stored_proof,
--         stored_ladder, stored_probe, stored_buffered, stored_extent, stored_limit, stored_judgement, stored_episode, stored_label,
--         stored_visible_bucket, stored_visible_novel, stored_program, stored_unknown_program
-- A row:  one kind of them that there is: the table, what it lacks, and how many.
-- Slots:  :whole  1 where a run and a calibration are there as a whole or not at all
SELECT of_table, lacks, CAST(SUM(looked.orphans) AS BIGINT) AS orphans
FROM (
  SELECT 'channel' AS of_table, 'monitor' AS lacks, CASE WHEN owner.hit = 1 THEN 0 ELSE 1 END AS orphans
  FROM stored_channel AS orphan
  LEFT JOIN (
    SELECT DISTINCT monitor_id, 1 AS hit
    FROM stored_monitor
  ) AS owner ON owner.monitor_id = orphan.monitor_id
  UNION ALL
  SELECT 'proof' AS of_table, 'monitor' AS lacks, CASE WHEN owner.hit = 1 THEN 0 ELSE 1 END AS orphans
  FROM stored_proof AS orphan
  LEFT JOIN (
    SELECT DISTINCT monitor_id, 1 AS hit
    FROM stored_monitor
  ) AS owner ON owner.monitor_id = orphan.monitor_id
  UNION ALL
  SELECT orphan.of_table AS of_table, 'monitor' AS lacks, CASE WHEN owner.hit = 1 THEN 0 ELSE 1 END AS orphans
  FROM (
    SELECT 'episode' AS of_table, monitor_id
    FROM stored_episode
    UNION ALL
    SELECT 'label' AS of_table, monitor_id
    FROM stored_label
  ) AS orphan
  LEFT JOIN (
    SELECT DISTINCT monitor_id, 1 AS hit
    FROM stored_monitor
  ) AS owner ON owner.monitor_id = orphan.monitor_id
  UNION ALL
  SELECT 'version' AS of_table, 'channel' AS lacks, CASE WHEN owner.hit = 1 THEN 0 ELSE 1 END AS orphans
  FROM stored_version AS orphan
  LEFT JOIN (
    SELECT DISTINCT channel_id, 1 AS hit
    FROM stored_channel
  ) AS owner ON owner.channel_id = orphan.channel_id
  UNION ALL
  SELECT
    orphan.of_table AS of_table,
    'version' AS lacks,
    CASE WHEN owner.hit = 1 THEN 0 WHEN :whole = 0 AND orphan.is_written_first = 1 THEN 0 ELSE 1 END
      AS orphans
  FROM (
    SELECT DISTINCT 'bucket' AS of_table, version_id, 0 AS is_written_first
    FROM stored_bucket
    UNION ALL
    SELECT DISTINCT 'novel' AS of_table, version_id, 0 AS is_written_first
    FROM stored_novel
    UNION ALL
    SELECT DISTINCT 'run' AS of_table, version_id, 0 AS is_written_first
    FROM stored_run
    UNION ALL
    SELECT DISTINCT 'horizon' AS of_table, version_id, 0 AS is_written_first
    FROM stored_horizon
    UNION ALL
    SELECT DISTINCT 'calibration' AS of_table, version_id, 1 AS is_written_first
    FROM stored_calibration
    UNION ALL
    SELECT DISTINCT 'checksum' AS of_table, version_id, 1 AS is_written_first
    FROM stored_checksum
    UNION ALL
    SELECT DISTINCT 'buffered' AS of_table, version_id, 1 AS is_written_first
    FROM stored_buffered
    UNION ALL
    SELECT DISTINCT 'extent' AS of_table, version_id, 1 AS is_written_first
    FROM stored_extent
    UNION ALL
    SELECT DISTINCT 'limit' AS of_table, version_id, 1 AS is_written_first
    FROM stored_limit
    UNION ALL
    SELECT DISTINCT 'judgement' AS of_table, version_id, 0 AS is_written_first
    FROM stored_judgement
    UNION ALL
    SELECT DISTINCT 'unknown_program' AS of_table, version_id, 0 AS is_written_first
    FROM stored_unknown_program
  ) AS orphan
  LEFT JOIN (
    SELECT DISTINCT version_id, 1 AS hit
    FROM stored_version
  ) AS owner ON owner.version_id = orphan.version_id
  UNION ALL
  SELECT
    orphan.of_table AS of_table,
    'version' AS lacks,
    CASE WHEN owner.hit = 1 THEN 0 WHEN :whole = 0 THEN 0 ELSE 1 END AS orphans
  FROM (
    SELECT DISTINCT 'bounds' AS of_table, support_id
    FROM stored_bounds
    UNION ALL
    SELECT DISTINCT 'block' AS of_table, support_id
    FROM stored_block
    UNION ALL
    SELECT DISTINCT 'support' AS of_table, support_id
    FROM stored_support
    UNION ALL
    SELECT DISTINCT 'ladder' AS of_table, support_id
    FROM stored_ladder
    UNION ALL
    SELECT DISTINCT 'probe' AS of_table, support_id
    FROM stored_probe
    UNION ALL
    SELECT DISTINCT 'program' AS of_table, support_id
    FROM stored_program
  ) AS orphan
  LEFT JOIN (
    SELECT DISTINCT support_id, 1 AS hit
    FROM stored_version
  ) AS owner ON owner.support_id = orphan.support_id
  UNION ALL
  SELECT
    orphan.of_table AS of_table,
    'run' AS lacks,
    CASE
      WHEN owner.hit = 1 THEN 0
      WHEN :whole = 1 OR elsewhere.hit = 1 THEN 1
      ELSE 0
    END AS orphans
  FROM (
    SELECT DISTINCT 'bucket' AS of_table, version_id, run_id
    FROM stored_bucket
    UNION ALL
    SELECT DISTINCT 'novel' AS of_table, version_id, run_id
    FROM stored_novel
    UNION ALL
    SELECT DISTINCT 'unknown_program' AS of_table, version_id, run_id
    FROM stored_unknown_program
  ) AS orphan
  LEFT JOIN (
    SELECT DISTINCT version_id, run_id, 1 AS hit
    FROM stored_run
  ) AS owner ON owner.version_id = orphan.version_id AND owner.run_id = orphan.run_id
  LEFT JOIN (
    SELECT DISTINCT run_id, 1 AS hit
    FROM stored_run
  ) AS elsewhere ON elsewhere.run_id = orphan.run_id
  UNION ALL
  SELECT 'novel' AS of_table, 'bucket' AS lacks, CASE WHEN owner.hit = 1 THEN 0 ELSE 1 END AS orphans
  FROM (
    SELECT DISTINCT version_id, bucket_no
    FROM stored_visible_novel
  ) AS orphan
  LEFT JOIN (
    SELECT DISTINCT version_id, bucket_no, 1 AS hit
    FROM stored_visible_bucket
  ) AS owner ON owner.version_id = orphan.version_id AND owner.bucket_no = orphan.bucket_no
  UNION ALL
  SELECT doubled.of_table AS of_table, 'another key' AS lacks, 1 AS orphans
  FROM (
    SELECT 'monitor' AS of_table, monitor_id AS doubled_id
    FROM stored_monitor
    GROUP BY monitor_id
    HAVING COUNT(*) > 1
    UNION ALL
    SELECT 'channel' AS of_table, channel_id AS doubled_id
    FROM stored_channel
    GROUP BY channel_id
    HAVING COUNT(*) > 1
    UNION ALL
    SELECT 'version' AS of_table, version_id AS doubled_id
    FROM stored_version
    GROUP BY version_id
    HAVING COUNT(*) > 1
    UNION ALL
    SELECT 'channel' AS of_table, MIN(channel_id) AS doubled_id
    FROM stored_channel
    GROUP BY monitor_id, asset, channel
    HAVING COUNT(*) > 1
    UNION ALL
    SELECT 'monitor' AS of_table, MIN(monitor_id) AS doubled_id
    FROM stored_monitor
    GROUP BY name
    HAVING COUNT(*) > 1
  ) AS doubled
) AS looked
WHERE looked.orphans = 1
GROUP BY of_table, lacks
