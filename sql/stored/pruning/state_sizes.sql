-- State sizes: how many rows the state holds of each channel of a monitor, whether visible or not.
-- Reads:  stored_monitor, stored_channel, stored_version, stored_bucket, stored_novel, stored_run, stored_support
-- A row:  one channel, in order. A support that a pool shares counts for each of its channels.
-- Slots:  :monitor  its name
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(COUNT(*) AS BIGINT) AS versions,
  CAST(SUM(CASE WHEN filled.hit = 1 THEN filled.held ELSE 0 END) AS BIGINT) AS bucket_rows,
  CAST(SUM(CASE WHEN unseen.hit = 1 THEN unseen.held ELSE 0 END) AS BIGINT) AS novel_rows,
  CAST(SUM(CASE WHEN done.hit = 1 THEN done.held ELSE 0 END) AS BIGINT) AS run_rows,
  CAST(SUM(CASE WHEN learnt.hit = 1 THEN learnt.held ELSE 0 END) AS BIGINT) AS support_rows
FROM stored_version AS version
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id
LEFT JOIN (
  SELECT version_id, CAST(COUNT(*) AS BIGINT) AS held, 1 AS hit
  FROM stored_bucket
  GROUP BY version_id
) AS filled ON filled.version_id = version.version_id
LEFT JOIN (
  SELECT version_id, CAST(COUNT(*) AS BIGINT) AS held, 1 AS hit
  FROM stored_novel
  GROUP BY version_id
) AS unseen ON unseen.version_id = version.version_id
LEFT JOIN (
  SELECT version_id, CAST(COUNT(*) AS BIGINT) AS held, 1 AS hit
  FROM stored_run
  GROUP BY version_id
) AS done ON done.version_id = version.version_id
LEFT JOIN (
  SELECT support_id, CAST(COUNT(*) AS BIGINT) AS held, 1 AS hit
  FROM stored_support
  GROUP BY support_id
) AS learnt ON learnt.support_id = version.support_id
WHERE watching.name = :monitor
GROUP BY named.asset, named.channel
ORDER BY named.asset, named.channel
