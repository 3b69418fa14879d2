-- Vouched verdicts: the verdicts, of a member that taught nothing by what the others say of it (both sides, section 6).
-- Reads:  verdicts, bounds, member_sizes, vouching
-- A row:  one channel; vouched_by counts the machines that taught, NULL where it is one of them or nobody did. taught_by
--         names them to all members of a pool; member_floor is the floor by leaving out one of them after another.
SELECT
  learnt.channel_id AS channel_id,
  CASE WHEN others.hit = 1 THEN others.verdict ELSE learnt.verdict END AS verdict,
  learnt.vectors AS vectors,
  learnt.cells AS cells,
  learnt.seen_once AS seen_once,
  learnt.blocks AS blocks,
  CASE WHEN others.hit = 1 THEN others.floor ELSE learnt.floor END AS floor,
  CASE WHEN others.hit = 1 THEN others.floor_sd ELSE learnt.floor_sd END AS floor_sd,
  CASE WHEN others.hit = 1 THEN others.floor_max ELSE learnt.floor_max END AS floor_max,
  CASE WHEN others.hit = 1 THEN others.finest_bins ELSE learnt.finest_bins END AS finest_bins,
  CASE
    WHEN others.hit = 1 THEN CASE WHEN others.verdict = 'ready' THEN CAST(0 AS BIGINT) END
    ELSE learnt.vectors_needed
  END AS vectors_needed,
  CASE WHEN others.hit = 1 THEN others.teachers END AS vouched_by,
  CASE WHEN pool.hit = 1 THEN pool.taught_by END AS taught_by,
  CASE WHEN pool.hit = 1 THEN pool.member_floor END AS member_floor
FROM verdicts AS learnt
LEFT JOIN (
  SELECT
    scale.channel_id AS channel_id,
    says.verdict AS verdict,
    says.floor AS floor,
    says.floor_sd AS floor_sd,
    says.floor_max AS floor_max,
    says.finest_bins AS finest_bins,
    says.teachers AS teachers,
    1 AS hit
  FROM bounds AS scale
  JOIN vouching AS says ON says.support_id = scale.support_id
  LEFT JOIN (
    SELECT channel_id, 1 AS hit
    FROM member_sizes
  ) AS taught ON taught.channel_id = scale.channel_id
  WHERE CASE WHEN taught.hit = 1 THEN 1 ELSE 0 END < 1
) AS others ON others.channel_id = learnt.channel_id
LEFT JOIN (
  SELECT scale.channel_id AS channel_id, says.taught_by AS taught_by, says.floor AS member_floor, 1 AS hit
  FROM bounds AS scale
  JOIN vouching AS says ON says.support_id = scale.support_id
) AS pool ON pool.channel_id = learnt.channel_id
