-- Monitors: what is watched in this database, each under a name of its own.
-- Reads:  stored_monitor
-- A row:  one monitor.
SELECT
  watched.monitor_id AS monitor_id,
  watched.name AS name,
  watched.source AS source,
  watched.layout AS layout,
  watched.asset_column AS asset_column,
  watched.channel_column AS channel_column,
  watched.time_column AS time_column,
  watched.value_column AS value_column,
  watched.condition AS condition,
  watched.time_kind AS time_kind,
  watched.created AS created
FROM stored_monitor AS watched
