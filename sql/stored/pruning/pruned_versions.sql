-- Pruned versions: the versions of one monitor, and which of them go altogether.
-- Reads:  stored_version, stored_channel, stored_monitor
-- A row:  one version; versions_back = 0 is the active one; goes = 1 if more than the wanted number of
--         retired ones are newer.
-- Slots:  :monitor        its name
--         :keep_versions  retired versions of a channel that stay
SELECT
  version_id,
  channel_id,
  support_id,
  window_length,
  stride,
  versions_back,
  CASE WHEN versions_back > :keep_versions THEN 1 ELSE 0 END AS goes
FROM (
  SELECT
    version.version_id AS version_id,
    version.channel_id AS channel_id,
    version.support_id AS support_id,
    version.window_length AS window_length,
    version.stride AS stride,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY version.channel_id ORDER BY version.version_id DESC) AS BIGINT
    ) - 1 AS versions_back
  FROM stored_version AS version
  JOIN stored_channel AS named ON named.channel_id = version.channel_id
  JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id
  WHERE watching.name = :monitor
) AS ranked
