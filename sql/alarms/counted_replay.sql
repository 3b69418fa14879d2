-- Counted replay: how many episodes the calibration of a family would have shown under each height.
-- Reads:  merged_replay, members
-- A row:  one height of one family under which there is an episode.
SELECT
  member.family_no AS family_no,
  episode.limit_no AS quarters,
  CAST(COUNT(*) AS BIGINT) AS episodes
FROM merged_replay AS episode
JOIN members AS member ON member.channel_id = episode.channel_id
GROUP BY member.family_no, episode.limit_no
