-- Window changed: as changed, of the channels whose windows have so many buckets.
-- Reads:  changed, cohort
-- A row:  one channel.
-- Slots:  :buckets  W / stride, the buckets of a window
SELECT
  part.channel_id AS channel_id,
  part.version_id AS version_id,
  part.first_bucket AS first_bucket,
  part.differs AS differs
FROM changed AS part
JOIN cohort AS member ON member.channel_id = part.channel_id
WHERE member.buckets = :buckets
