-- Novel rows: what a run appends to the stored novel cells.
-- Reads:  novel_cells, cohort, changed, stamp
-- A row:  one cell outside the support in one full bucket.
SELECT
  member.version_id AS version_id,
  strange.bucket_no + member.first_bucket AS bucket_no,
  stamp.run_id AS run_id,
  strange.cell_key AS cell_key,
  strange.visits AS visits,
  strange.first_time AS first_time,
  strange.last_time AS last_time
FROM novel_cells AS strange
JOIN cohort AS member ON member.channel_id = strange.channel_id
JOIN changed AS part ON part.channel_id = strange.channel_id
CROSS JOIN stamp
WHERE strange.bucket_no + member.first_bucket >= part.first_bucket
ORDER BY member.version_id, strange.bucket_no
