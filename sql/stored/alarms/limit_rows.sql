-- Limit rows: the newest limit of each active version of a monitor.
-- Reads:  active, stored_limit
-- A row:  one version; of one without any row, made before limits were, all but its names is NULL.
SELECT
  member.asset AS asset,
  member.channel AS channel,
  member.channel_id AS channel_id,
  member.version_id AS version_id,
  CASE WHEN newest.hit = 1 THEN newest.limit_no ELSE 0 END AS limit_no,
  CASE WHEN newest.hit = 1 THEN newest.from_judgement END AS from_judgement,
  CASE WHEN newest.hit = 1 THEN newest.cause END AS cause,
  CASE WHEN newest.hit = 1 THEN newest.asked END AS asked,
  CASE WHEN newest.hit = 1 THEN newest.family END AS family,
  CASE WHEN newest.hit = 1 THEN newest.blocks END AS blocks,
  CASE WHEN newest.hit = 1 THEN newest.g END AS g,
  CASE WHEN newest.hit = 1 THEN newest.centre END AS centre,
  CASE WHEN newest.hit = 1 THEN newest.spread END AS spread,
  CASE WHEN newest.hit = 1 THEN newest.reference END AS reference,
  CASE WHEN newest.hit = 1 THEN newest.height END AS height,
  CASE WHEN newest.hit = 1 THEN newest.cap END AS cap,
  CASE WHEN newest.hit = 1 THEN newest.quarters END AS quarters,
  CASE WHEN newest.hit = 1 THEN newest.basis END AS basis,
  CASE WHEN newest.hit = 1 THEN newest.order_ratio END AS order_ratio,
  CASE WHEN newest.hit = 1 THEN newest.judgements_per_day END AS judgements_per_day,
  CASE WHEN newest.hit = 1 THEN newest.rate END AS rate,
  CASE WHEN newest.hit = 1 THEN newest.stated_rate END AS stated_rate,
  CASE WHEN newest.hit = 1 THEN newest.reason ELSE 'calibrated before there were limits' END AS reason
FROM active AS member
LEFT JOIN (
  SELECT
    limit_row.version_id AS version_id,
    limit_row.limit_no AS limit_no,
    limit_row.from_judgement AS from_judgement,
    limit_row.cause AS cause,
    limit_row.asked AS asked,
    limit_row.family AS family,
    limit_row.blocks AS blocks,
    limit_row.g AS g,
    limit_row.centre AS centre,
    limit_row.spread AS spread,
    limit_row.reference AS reference,
    limit_row.height AS height,
    limit_row.cap AS cap,
    limit_row.quarters AS quarters,
    limit_row.basis AS basis,
    limit_row.order_ratio AS order_ratio,
    limit_row.judgements_per_day AS judgements_per_day,
    limit_row.rate AS rate,
    limit_row.stated_rate AS stated_rate,
    limit_row.reason AS reason,
    1 AS hit
  FROM stored_limit AS limit_row
  JOIN (
    SELECT version_id, MAX(each_limit.limit_no) AS newest_no
    FROM stored_limit AS each_limit
    GROUP BY version_id
  ) AS latest ON latest.version_id = limit_row.version_id AND latest.newest_no = limit_row.limit_no
) AS newest ON newest.version_id = member.version_id
ORDER BY member.asset, member.channel
