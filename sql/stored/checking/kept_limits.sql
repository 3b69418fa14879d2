-- Kept limits: limits of a monitor as they are kept, all but what only people read.
-- Reads:  stored_limit, stored_version, stored_channel
-- A row:  one limit of one version, in order.
-- Slots:  :monitor_id
SELECT
  made.version_id AS version_id,
  made.limit_no AS limit_no,
  made.from_judgement AS from_judgement,
  made.cause AS cause,
  made.asked AS asked,
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
  made.reason AS reason
FROM stored_limit AS made
JOIN stored_version AS judged ON judged.version_id = made.version_id
JOIN stored_channel AS named ON named.channel_id = judged.channel_id
WHERE named.monitor_id = :monitor_id
ORDER BY made.version_id, made.limit_no
