-- Program verdicts: as verdicts, and a calibration that holds enough of no program needs data, however much it holds of all.
-- Reads:  verdicts, bounds, judged_programs
-- A row:  one channel.
-- Slots:  :vouched  who vouches for a channel of a pool; nothing where there are no pools
SELECT
  learnt.channel_id AS channel_id,
  CASE
    WHEN learnt.verdict <> 'ready' THEN learnt.verdict
    WHEN ran.hit = 1 THEN learnt.verdict
    ELSE 'needs_data'
  END AS verdict,
  learnt.vectors AS vectors,
  learnt.cells AS cells,
  learnt.seen_once AS seen_once,
  learnt.blocks AS blocks,
  learnt.floor AS floor,
  learnt.floor_sd AS floor_sd,
  learnt.floor_max AS floor_max,
  learnt.finest_bins AS finest_bins,
  learnt.vectors_needed AS vectors_needed,
  :vouched
FROM verdicts AS learnt
JOIN bounds AS scale ON scale.channel_id = learnt.channel_id
LEFT JOIN (
  SELECT support_id, 1 AS hit
  FROM judged_programs
  GROUP BY support_id
) AS ran ON ran.support_id = scale.support_id
