-- Backtested: what the limits raise where nothing was wrong (alarms, section 3: the seen rate).
-- Reads:  frozen_limits, judged_windows, merged, channels
-- A row:  one channel with a limit that was judged there; an episode counts where it opened.
-- Slots:  :healthy  which judgements count
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(COUNT(*) AS BIGINT) AS judgements,
  CAST(SUM(CASE WHEN opening.hit = 1 THEN 1 ELSE 0 END) AS BIGINT) AS episodes
FROM frozen_limits AS frozen
JOIN channels AS named ON named.channel_id = frozen.channel_id
JOIN judged_windows AS counted ON counted.channel_id = frozen.channel_id
LEFT JOIN (
  SELECT channel_id, first_judgement, 1 AS hit
  FROM merged
) AS opening
  ON opening.channel_id = counted.channel_id AND opening.first_judgement = counted.judgement_no
WHERE :healthy
GROUP BY named.asset, named.channel
ORDER BY named.asset, named.channel
