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
    made.version_id AS version_id,
    made.limit_no AS limit_no,
    made.from_judgement AS from_judgement,
    made.cause AS cause,
    made.asked AS asked,
    made.family AS family,
    made.blocks AS blocks,
    made.g AS g,
    made.centre AS centre,
    made.spread AS spread,
    made.reference AS reference,
    made.height AS height,
    made.cap AS cap,
    made.quarters AS quarters,
    made.basis AS basis,
    made.order_ratio AS order_ratio,
    made.judgements_per_day AS judgements_per_day,
    made.rate AS rate,
    made.stated_rate AS stated_rate,
    made.reason AS reason,
    1 AS hit
  FROM stored_limit AS made
  JOIN (
    SELECT version_id, MAX(each_limit.limit_no) AS newest_no
    FROM stored_limit AS each_limit
    GROUP BY version_id
  ) AS latest ON latest.version_id = made.version_id AND latest.newest_no = made.limit_no
) AS newest ON newest.version_id = member.version_id
ORDER BY member.asset, member.channel
