-- Standing: what each channel is at its end. One that would be ok, blind or waiting and stands still there is standing: neither
-- healthy nor alarming. This is the one place that says it.
-- Reads:  judged, channels, stillness
-- A row:  one channel; still_tick is since when it stands still, as far as it is scored, NULL where it moves.
-- Slots:  :columns  what else is known of a channel, all of which goes on
SELECT
  CASE WHEN still.hit = 1 AND judged.status IN ('ok', 'waiting', 'blind') THEN 'standing' ELSE judged.status END AS status,
  CASE WHEN still.hit = 1 AND judged.status = 'ok' THEN NULL ELSE judged.is_above END AS is_above,
  CASE WHEN still.hit = 1 THEN still.still_since END AS still_tick,
  :columns
FROM judged
JOIN channels AS named ON named.asset = judged.asset AND named.channel = judged.channel
LEFT JOIN (
  SELECT channel_id, still_since, 1 AS hit
  FROM stillness
  WHERE still_since IS NOT NULL
) AS still ON still.channel_id = named.channel_id
