-- Attention: what asks for it of each channel, under its active version: episodes, where the newest limit of the version is
-- one, else the indicator; and the episode that is open.
CREATE OR REPLACE VIEW stored_attention AS
SELECT
  known.monitor AS monitor,
  known.asset AS asset,
  known.channel AS channel,
  known.version_no AS version_no,
  known.version_id AS version_id,
  CASE WHEN limited.hit = 1 THEN 'episode' WHEN known.hi_limit IS NOT NULL THEN 'indicator' END AS judged_by,
  CASE WHEN raised.hit = 1 THEN raised.episode_id END AS episode_id,
  CASE WHEN raised.hit = 1 AND watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(raised.onset_tick) END
    AS onset_time,
  CASE WHEN raised.hit = 1 THEN raised.onset_tick END AS onset_tick
FROM stored_fleet AS known
JOIN stored_version AS version ON version.version_id = known.version_id
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id
LEFT JOIN (
  SELECT own.version_id AS version_id, 1 AS hit
  FROM stored_limit AS own
  JOIN (
    SELECT version_id, MAX(each_limit.limit_no) AS newest_no
    FROM stored_limit AS each_limit
    GROUP BY version_id
  ) AS latest ON latest.version_id = own.version_id AND latest.newest_no = own.limit_no
  WHERE own.reason IS NULL
  GROUP BY own.version_id
) AS limited ON limited.version_id = version.version_id
LEFT JOIN (
  SELECT
    channel_id,
    MAX(going.episode_id) AS episode_id,
    MAX(going.onset_time) AS onset_tick,
    1 AS hit
  FROM stored_visible_episode AS going
  WHERE going.status = 'open'
  GROUP BY channel_id
) AS raised ON raised.channel_id = named.channel_id;

COMMENT ON VIEW stored_attention
  IS 'What asks for attention of each channel: its episodes or its indicator; one row per channel';
COMMENT ON COLUMN stored_attention.monitor IS 'The monitor';
COMMENT ON COLUMN stored_attention.asset IS 'The machine';
COMMENT ON COLUMN stored_attention.channel IS 'The signal';
COMMENT ON COLUMN stored_attention.version_no IS 'Which calibration of the channel: 1, 2, ...; the active one';
COMMENT ON COLUMN stored_attention.version_id IS 'Its key in the other tables';
COMMENT ON COLUMN stored_attention.judged_by
  IS 'episode: its calibration gave a limit of judgements; indicator: only hi_limit; NULL: nothing does';
COMMENT ON COLUMN stored_attention.episode_id IS 'Its episode that is open; NULL where none is';
COMMENT ON COLUMN stored_attention.onset_time
  IS 'When the judgement begins in which evidence of that left 0 (UTC); NULL where the source counts time';
COMMENT ON COLUMN stored_attention.onset_tick
  IS 'The same in microseconds since 1970 (UTC), or as the counter of the source';
