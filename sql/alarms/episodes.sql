-- Episodes: when a channel was raised, and since when.
-- Reads:  merged, opened, judged_windows, frozen_limits, channels
-- A row:  one episode, in order. is_open = 1 if the channel's newest judgement is open and this is its last one;
--         is_proving = 1 if it opened within as many judgements as calibration has blocks. Evidence is the highest in it,
--         height what opened it: 1 where the indicator did.
-- Slots:  :first_time, :last_time  when its first open judgement begins and its last one ends
--         :onset_time              when the judgement begins in which evidence left 0
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(merged_episode.episode_no AS BIGINT) AS episode,
  CAST(merged_episode.onset AS BIGINT) AS onset,
  CAST(merged_episode.first_judgement AS BIGINT) AS first_judgement,
  CAST(merged_episode.last_judgement AS BIGINT) AS last_judgement,
  :onset_time AS onset_time,
  :first_time AS first_time,
  :last_time AS last_time,
  CAST(strongest.evidence AS BIGINT) AS evidence,
  CAST(strongest.height AS BIGINT) AS height,
  CAST(CASE WHEN merged_episode.last_judgement = newest.last_judgement THEN 1 ELSE 0 END AS BIGINT) AS is_open,
  CAST(CASE WHEN merged_episode.first_judgement < frozen.blocks THEN 1 ELSE 0 END AS BIGINT) AS is_proving
FROM merged AS merged_episode
JOIN channels AS named ON named.channel_id = merged_episode.channel_id
JOIN frozen_limits AS frozen ON frozen.channel_id = merged_episode.channel_id
JOIN (
  SELECT channel_id, MAX(judgement_no) AS last_judgement
  FROM opened
  GROUP BY channel_id
) AS newest ON newest.channel_id = merged_episode.channel_id
JOIN (
  SELECT
    going.channel_id AS channel_id,
    going.limit_no AS limit_no,
    going.episode_no AS episode_no,
    MAX(judgement_row.evidence) AS evidence,
    MAX(CASE WHEN judgement_row.judgement_no = going.first_judgement THEN judgement_row.height END) AS height
  FROM merged AS going
  JOIN opened AS judgement_row
    ON judgement_row.channel_id = going.channel_id
    AND judgement_row.judgement_no >= going.onset
    AND judgement_row.judgement_no <= going.last_judgement
  GROUP BY going.channel_id, going.limit_no, going.episode_no
) AS strongest
  ON strongest.channel_id = merged_episode.channel_id
  AND strongest.limit_no = merged_episode.limit_no
  AND strongest.episode_no = merged_episode.episode_no
JOIN judged_windows AS beginning
  ON beginning.channel_id = merged_episode.channel_id AND beginning.judgement_no = merged_episode.onset
JOIN judged_windows AS opening
  ON opening.channel_id = merged_episode.channel_id AND opening.judgement_no = merged_episode.first_judgement
JOIN judged_windows AS closing
  ON closing.channel_id = merged_episode.channel_id AND closing.judgement_no = merged_episode.last_judgement
ORDER BY named.asset, named.channel, merged_episode.episode_no
