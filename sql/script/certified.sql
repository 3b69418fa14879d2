-- Certified: the verdict, and what the indicator of a channel would show if its machine changed.
-- Reads:  verdicts, sight
-- Slots:  :columns        those of the verdicts
--         :would_not_see  what would not be seen
--         :blind_reason   why nothing would be seen
SELECT
  learnt.asset AS asset,
  :columns,
  CASE WHEN probed.hit = 1 THEN probed.usual_low END AS usual_low,
  CASE WHEN probed.hit = 1 THEN probed.usual_middle END AS usual_middle,
  CASE WHEN probed.hit = 1 THEN probed.usual_high END AS usual_high,
  CASE WHEN probed.hit = 1 THEN probed.sees END AS sees,
  CASE WHEN probed.hit = 1 THEN probed.sees_half_stroke END AS sees_half_stroke,
  CASE WHEN probed.hit = 1 THEN probed.sees_frozen END AS sees_frozen,
  CASE WHEN probed.hit = 1 THEN probed.sees_faster END AS sees_faster,
  CASE WHEN probed.hit = 1 THEN probed.sees_slower END AS sees_slower,
  CASE WHEN probed.hit = 1 THEN :would_not_see END AS would_not_see,
  CASE WHEN learnt.verdict = 'ready' AND probed.hit = 1 AND probed.sees IS NULL THEN :blind_reason END
    AS blind_reason
FROM verdicts AS learnt
LEFT JOIN (
  SELECT
    asset,
    channel,
    usual_low,
    usual_middle,
    usual_high,
    usual_width,
    hi_limit,
    sees,
    sees_half_stroke,
    sees_frozen,
    sees_faster,
    sees_slower,
    1 AS hit
  FROM sight
) AS probed ON probed.asset = learnt.asset AND probed.channel = learnt.channel
