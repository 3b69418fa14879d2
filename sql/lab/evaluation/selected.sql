-- Selected: the values that are evaluated, which end with the failure where one is known.
-- Reads:  indicator, members
-- A row:  one value of one series.
SELECT
  member.series_id AS series_id,
  member.steps AS steps,
  given.place AS place,
  given.hi AS hi,
  given.novel_in_window AS novel_in_window
FROM indicator AS given
JOIN members AS member ON member.asset = given.asset AND member.channel = given.channel
WHERE given.hi IS NOT NULL AND given.time <= member.ends_at
