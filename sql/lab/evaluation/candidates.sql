-- Candidates: the channels of the table, and what is to be known of them before their series are cut.
-- Reads:  indicator
-- A row:  one (asset, channel) pair, a missing name included, so that it can be refused.
SELECT
  asset,
  channel,
  CAST(COUNT(*) AS BIGINT) AS rows_read,
  CAST(COUNT(place) AS BIGINT) AS numbered_values,
  CAST(COUNT(time) AS BIGINT) AS dated_values,
  CAST(COUNT(DISTINCT place) AS BIGINT) AS places,
  CAST(COUNT(hi) AS BIGINT) AS hi_values,
  CAST(COUNT(novel_in_window) AS BIGINT) AS counted_values,
  MIN(CASE WHEN hi IS NOT NULL THEN place END) AS first_place,
  MAX(indicator_row.vectors_in_window) AS vectors_in_window,
  MIN(CASE WHEN hi IS NOT NULL THEN novel_in_window END) AS lowest_count,
  MAX(CASE WHEN hi IS NOT NULL THEN novel_in_window END) AS highest_count,
  MAX(hi) AS highest_hi,
  MIN(hi) AS lowest_hi,
  MAX(indicator_row.hi_limit) AS hi_limit
FROM indicator AS indicator_row
GROUP BY asset, channel
