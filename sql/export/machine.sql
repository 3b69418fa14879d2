-- Machine, dbt form: what is known of every machine now, counted over its signals. Together counts the signals whose
-- onset lies within the window that ended at the onset of one of them.
-- Reads:  stored_channel, judged, machines
-- A row:  one machine.
-- Slots:  :times  since_time and last_time as the source tells time; nothing where it counts
SELECT
  machine_row.asset AS asset,
  machine_row.signals AS signals,
  machine_row.watched AS watched,
  machine_row.not_watched AS not_watched,
  counted.judged AS judged,
  machine_row.above AS above,
  counted.not_judged AS not_judged,
  :times,
  machine_row.since_tick AS since_tick,
  machine_row.first_channel AS first_channel,
  machine_row.strongest_channel AS strongest_channel,
  machine_row.strength AS strength,
  machine_row.urgency AS urgency,
  machine_row.machine_rank AS machine_rank,
  counted.together AS together,
  counted.last_tick AS last_tick
FROM machines AS machine_row
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
      signal_row.is_above AS is_above,
      signal_row.last_tick AS last_tick,
      CAST(SUM(CASE WHEN other.since_tick >= signal_row.window_from_tick AND other.since_tick <= signal_row.since_tick
        THEN 1 ELSE 0 END) AS BIGINT) AS left_together
    FROM judged AS signal_row
    JOIN stored_channel AS named ON named.channel_id = signal_row.channel_id
    JOIN stored_channel AS mate ON mate.asset = named.asset
    JOIN judged AS other ON other.channel_id = mate.channel_id
    GROUP BY named.asset, signal_row.channel_id, signal_row.is_above, signal_row.since_tick, signal_row.last_tick
  ) AS signal
  GROUP BY signal.asset
) AS counted ON counted.asset = machine_row.asset
