-- Selected: the values that are evaluated, which end with the failure where one is known.
-- Reads:  indicator, members
-- A row:  one value of one series.
SELECT
  member.series_id AS series_id,
  member.steps AS steps,
  indicator_row.place AS place,
  indicator_row.hi AS hi,
  indicator_row.novel_in_window AS novel_in_window
FROM indicator AS indicator_row
JOIN members AS member ON member.asset = indicator_row.asset AND member.channel = indicator_row.channel
WHERE indicator_row.hi IS NOT NULL AND indicator_row.time <= member.ends_at
