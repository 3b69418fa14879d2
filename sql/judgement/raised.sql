-- Raised: each channel with what it is judged by, and what its episodes say of it now: after its newest judgement, and
-- with nobody's word on them, so that one that opened right after calibration asks for a decision even when it is over.
-- Reads:  assessed, limit_reasons, episodes
-- A row:  one channel; episode is the open one, else the newest that asks, and asking counts those.
SELECT
  assessment.asset AS asset,
  assessment.channel AS channel,
  assessment.verdict AS verdict,
  assessment.hi_limit AS hi_limit,
  CASE WHEN limited.reason = 'unrepresentative' THEN limited.reason ELSE assessment.limit_reason END AS limit_reason,
  assessment.hi AS hi,
  CASE WHEN limited.reason IS NULL THEN 1 WHEN limited.reason = 'unrepresentative' THEN 0 ELSE -1 END AS has_limit,
  CASE
    WHEN going.hit = 1
      THEN CASE WHEN limited.reason IS NOT NULL THEN 'high' WHEN going.is_proving = 1 THEN 'proving' ELSE 'open' END
  END AS raised,
  CASE WHEN going.hit = 1 THEN CAST(going.evidence AS DOUBLE) / CAST(going.height AS DOUBLE) END AS sure,
  CASE WHEN going.hit = 1 THEN 1 ELSE 0 END AS asks,
  CASE WHEN going.hit = 1 THEN going.asking ELSE 0 END AS asking,
  CASE WHEN going.hit = 1 THEN going.episode END AS episode,
  CASE WHEN going.hit = 1 THEN going.is_open END AS is_open,
  CASE WHEN going.hit = 1 THEN going.onset_time END AS onset,
  CASE WHEN going.hit = 1 THEN going.onset_time END AS since_tick
FROM assessed AS assessment
JOIN limit_reasons AS limited ON limited.asset = assessment.asset AND limited.channel = assessment.channel
LEFT JOIN (
  SELECT
    asset,
    channel,
    episode,
    is_open,
    is_proving,
    onset_time,
    evidence,
    height,
    CAST(COUNT(*) OVER (PARTITION BY asset, channel) AS BIGINT) AS asking,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY asset, channel ORDER BY is_open DESC, episode DESC) AS BIGINT
    ) AS episodes_back,
    1 AS hit
  FROM episodes
  WHERE is_open = 1 OR is_proving = 1
) AS going
  ON going.asset = assessment.asset AND going.channel = assessment.channel AND going.episodes_back = 1
