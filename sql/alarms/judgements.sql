-- Judgements: each full window of a channel that has a limit, with what it says.
-- Reads:  opened, judged_windows, channels
-- A row:  one judgement, in order.
-- Slots:  :first_time, :last_time  the instants of its first and last vector as the source tells time
SELECT
  named.asset AS asset,
  named.channel AS channel,
  judgement_row.judgement_no AS judgement,
  :first_time AS first_time,
  :last_time AS last_time,
  CAST(counted.novel AS BIGINT) AS novel,
  CAST(judgement_row.root AS BIGINT) AS root,
  CAST(judgement_row.reference AS BIGINT) AS reference,
  CAST(judgement_row.height AS BIGINT) AS height,
  CAST(judgement_row.evidence AS BIGINT) AS evidence,
  CAST(judgement_row.is_open AS BIGINT) AS is_open,
  CAST(judgement_row.last_zero AS BIGINT) AS last_zero
FROM opened AS judgement_row
JOIN judged_windows AS counted
  ON counted.channel_id = judgement_row.channel_id AND counted.judgement_no = judgement_row.judgement_no
JOIN channels AS named ON named.channel_id = judgement_row.channel_id
ORDER BY named.asset, named.channel, judgement_row.judgement_no
