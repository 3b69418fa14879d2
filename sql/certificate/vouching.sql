-- Vouching: what the members of a pool that taught say of one that did not: each of them left out and scored against the
-- others (both sides, section 6). One alone says nothing.
-- Reads:  channels, bounds, member_sizes, member_spread, member_finest
-- A row:  one support that somebody taught; taught_by names those machines, NULL where one channel stands alone.
SELECT
  scale.support_id AS support_id,
  whole.blocks AS teachers,
  CASE
    WHEN pool.members = 1 THEN NULL
    WHEN whole.blocks = 1 THEN teacher.first_asset
    WHEN whole.blocks = 2 THEN teacher.first_asset || ' and ' || teacher.second_asset
    WHEN whole.blocks = 3
      THEN teacher.first_asset || ', ' || teacher.second_asset || ' and ' || teacher.third_asset
    ELSE teacher.first_asset || ', ' || teacher.second_asset || ' and ' || CAST(whole.blocks - 2 AS VARCHAR) || ' more'
  END AS taught_by,
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
  SELECT support_id, CAST(COUNT(*) AS BIGINT) AS members
  FROM bounds
  GROUP BY support_id
) AS pool ON pool.support_id = scale.support_id
JOIN (
  SELECT
    member.support_id AS support_id,
    MIN(CASE WHEN member.pool_block = 0 THEN named.asset END) AS first_asset,
    MIN(CASE WHEN member.pool_block = 1 THEN named.asset END) AS second_asset,
    MIN(CASE WHEN member.pool_block = 2 THEN named.asset END) AS third_asset
  FROM member_sizes AS member
  JOIN channels AS named ON named.channel_id = member.channel_id
  GROUP BY member.support_id
) AS teacher ON teacher.support_id = scale.support_id
LEFT JOIN (
  SELECT support_id, finest_bins, 1 AS hit
  FROM member_finest
) AS grid ON grid.support_id = scale.support_id
WHERE scale.channel_id = scale.support_id
