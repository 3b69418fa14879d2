-- Vouching: what the members of a pool that taught say of one that did not: each of them left out and scored against the
-- others (both sides, section 6). One alone says nothing.
-- Reads:  channels, bounds, member_sizes, member_spread, member_finest
-- A row:  one support that somebody taught.
SELECT
  scale.support_id AS support_id,
  whole.blocks AS teachers,
  teacher.only_teacher AS only_teacher,
  CASE
    WHEN scale.calibrated_hi = scale.calibrated_lo THEN 'constant'
    WHEN whole.blocks = 1 THEN 'not_vouched'
    WHEN grid.hit = 1 AND grid.finest_bins = scale.bins THEN 'ready'
    WHEN grid.hit = 1 THEN 'too_fine'
    ELSE 'needs_data'
  END AS verdict,
  CASE WHEN whole.blocks > 1 THEN whole.floor END AS floor,
  CASE WHEN whole.blocks > 1 THEN whole.floor_sd END AS floor_sd,
  CASE WHEN whole.blocks > 1 THEN whole.floor_max END AS floor_max,
  CAST(CASE WHEN whole.blocks > 1 AND grid.hit = 1 THEN grid.finest_bins END AS BIGINT) AS finest_bins
FROM bounds AS scale
JOIN member_spread AS whole ON whole.support_id = scale.support_id
JOIN (
  SELECT member.support_id AS support_id, MIN(named.asset) AS only_teacher
  FROM member_sizes AS member
  JOIN channels AS named ON named.channel_id = member.channel_id
  GROUP BY member.support_id
) AS teacher ON teacher.support_id = scale.support_id
LEFT JOIN (
  SELECT support_id, finest_bins, 1 AS hit
  FROM member_finest
) AS grid ON grid.support_id = scale.support_id
WHERE scale.channel_id = scale.support_id
