-- Recorded limits: the limits of a monitor as the state has them, without the columns that only people read.
-- Reads:  stored_limit, stored_version, stored_channel
-- A row:  one limit of one version, in order.
-- Slots:  :monitor_id
SELECT
  limit_row.version_id AS version_id,
  limit_row.limit_no AS limit_no,
  limit_row.from_judgement AS from_judgement,
  limit_row.cause AS cause,
  limit_row.asked AS asked,
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
  limit_row.reason AS reason
FROM stored_limit AS limit_row
JOIN stored_version AS judged ON judged.version_id = limit_row.version_id
JOIN stored_channel AS named ON named.channel_id = judged.channel_id
WHERE named.monitor_id = :monitor_id
ORDER BY limit_row.version_id, limit_row.limit_no
