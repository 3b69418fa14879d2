-- Machine, dbt form: what is known of every machine now, counted over its signals. Together counts the signals whose
-- onset lies within the window that ended at the onset of one of them.
-- Reads:  stored_channel, judged
-- A row:  one machine.
-- Slots:  :times  since_time and data_time as the source tells time; nothing where it counts
SELECT
  made.asset AS asset,
  made.signals AS signals,
  made.judged AS judged,
  made.above AS above,
  made.not_judged AS not_judged,
  :times,
  made.since_tick AS since_tick,
  made.together AS together,
  made.last_tick AS last_tick
FROM (
  SELECT
    one.asset AS asset,
    CAST(COUNT(*) AS BIGINT) AS signals,
    CAST(SUM(CASE WHEN one.is_above IS NULL THEN 0 ELSE 1 END) AS BIGINT) AS judged,
    CAST(SUM(CASE WHEN one.is_above = 1 THEN 1 ELSE 0 END) AS BIGINT) AS above,
    CAST(SUM(CASE WHEN one.is_above IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS not_judged,
    MIN(one.since_tick) AS since_tick,
    MAX(one.left_together) AS together,
    MAX(one.last_tick) AS last_tick
  FROM (
    SELECT
      known.asset AS asset,
      own.is_above AS is_above,
      own.since_tick AS since_tick,
      own.last_tick AS last_tick,
      CAST(SUM(CASE WHEN other.since_tick >= own.window_from_tick AND other.since_tick <= own.since_tick
        THEN 1 ELSE 0 END) AS BIGINT) AS left_together
    FROM judged AS own
    JOIN stored_channel AS known ON known.channel_id = own.channel_id
    JOIN stored_channel AS mate ON mate.asset = known.asset
    JOIN judged AS other ON other.channel_id = mate.channel_id
    GROUP BY known.asset, own.channel_id, own.is_above, own.since_tick, own.last_tick
  ) AS one
  GROUP BY one.asset
) AS made
