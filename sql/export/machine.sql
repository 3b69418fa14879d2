-- Machine, dbt form: what is known of every machine now, counted over its signals. Together counts the signals whose
-- onset lies within the window that ended at the onset of one of them.
-- Reads:  stored_channel, judged, machines
-- A row:  one machine.
-- Slots:  :times  since_time and last_time as the source tells time; nothing where it counts
SELECT
  made.asset AS asset,
  made.signals AS signals,
  made.watched AS watched,
  made.not_watched AS not_watched,
  counted.judged AS judged,
  made.above AS above,
  counted.not_judged AS not_judged,
  :times,
  made.since_tick AS since_tick,
  made.first_channel AS first_channel,
  made.strongest_channel AS strongest_channel,
  made.strength AS strength,
  made.urgency AS urgency,
  made.machine_rank AS machine_rank,
  counted.together AS together,
  counted.last_tick AS last_tick
FROM machines AS made
JOIN (
  SELECT
    signal.asset AS asset,
    CAST(SUM(CASE WHEN signal.is_above IS NULL THEN 0 ELSE 1 END) AS BIGINT) AS judged,
    CAST(SUM(CASE WHEN signal.is_above IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS not_judged,
    MAX(signal.left_together) AS together,
    MAX(signal.last_tick) AS last_tick
  FROM (
    SELECT
      named.asset AS asset,
      own.is_above AS is_above,
      own.last_tick AS last_tick,
      CAST(SUM(CASE WHEN other.since_tick >= own.window_from_tick AND other.since_tick <= own.since_tick
        THEN 1 ELSE 0 END) AS BIGINT) AS left_together
    FROM judged AS own
    JOIN stored_channel AS named ON named.channel_id = own.channel_id
    JOIN stored_channel AS mate ON mate.asset = named.asset
    JOIN judged AS other ON other.channel_id = mate.channel_id
    GROUP BY named.asset, own.channel_id, own.is_above, own.since_tick, own.last_tick
  ) AS signal
  GROUP BY signal.asset
) AS counted ON counted.asset = made.asset
