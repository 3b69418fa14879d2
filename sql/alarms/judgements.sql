-- Judgements: each full window of a channel that has a limit, with what it says.
-- Reads:  opened, judged_windows, channels
-- A row:  one judgement, in order.
-- Slots:  :first_time, :last_time  the instants of its first and last vector as the source tells time
SELECT
  named.asset AS asset,
  named.channel AS channel,
  said.judgement_no AS judgement,
  :first_time AS first_time,
  :last_time AS last_time,
  CAST(counted.novel AS BIGINT) AS novel,
  CAST(said.root AS BIGINT) AS root,
  CAST(said.reference AS BIGINT) AS reference,
  CAST(said.height AS BIGINT) AS height,
  CAST(said.evidence AS BIGINT) AS evidence,
  CAST(said.is_open AS BIGINT) AS is_open,
  CAST(said.last_zero AS BIGINT) AS last_zero
FROM opened AS said
JOIN judged_windows AS counted
  ON counted.channel_id = said.channel_id AND counted.judgement_no = said.judgement_no
JOIN channels AS named ON named.channel_id = said.channel_id
ORDER BY named.asset, named.channel, said.judgement_no
