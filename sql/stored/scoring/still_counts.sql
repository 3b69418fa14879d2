-- Still counts: how many samples stood still after the last vector of the bucket before, up to the end of each.
-- Reads:  visited, stillness, cohort
-- A row:  one full bucket of one channel, numbered on from those that stay.
SELECT
  ended.channel_id AS channel_id,
  ended.bucket_no + member.first_bucket AS bucket_no,
  ended.end_still - CASE WHEN ended.bucket_no = 0 THEN calm.context_still ELSE ended.previous_still END AS still
FROM (
  SELECT
    visit.channel_id AS channel_id,
    visit.bucket_no AS bucket_no,
    visit.end_still AS end_still,
    LAG(visit.end_still, 1) OVER (PARTITION BY visit.channel_id ORDER BY visit.bucket_no) AS previous_still
  FROM visited AS visit
  WHERE visit.closing = 1
) AS ended
JOIN cohort AS member ON member.channel_id = ended.channel_id
JOIN stillness AS calm ON calm.channel_id = ended.channel_id
