-- Sight: which changes of a machine its indicator would show: those that lift it above its limit, if the machine works as
-- in calibration (both sides, sections 2 and 3).
-- Reads:  probe, changes, usual, spread, bounds
-- A row:  one support. sees is the smallest shift seen both ways, in percent of the usual width, NULL where none is; the
--         others are 1 or 0, and NULL where the change could not be tried.
-- Slots:  :hi_limit  the expression of judgement/limit.sql
SELECT
  support_id,
  MIN(weighed.usual_low) AS usual_low,
  MIN(weighed.usual_middle) AS usual_middle,
  MIN(weighed.usual_high) AS usual_high,
  MIN(weighed.usual_width) AS usual_width,
  MIN(weighed.hi_limit) AS hi_limit,
  MIN(CASE WHEN seen = 1 AND seen_both_ways = 2 THEN rung END) AS sees,
  MAX(CASE WHEN change_name = 'stroke 0.5' THEN seen END) AS sees_half_stroke,
  MAX(CASE WHEN change_name = 'frozen' THEN seen END) AS sees_frozen,
  MAX(CASE WHEN change_name = 'speed 3/2' THEN seen END) AS sees_faster,
  MAX(CASE WHEN change_name = 'speed 2/3' THEN seen END) AS sees_slower
FROM (
  SELECT
    changed.support_id AS support_id,
    changed.change_name AS change_name,
    changed.rung AS rung,
    changed.usual_low AS usual_low,
    changed.usual_middle AS usual_middle,
    changed.usual_high AS usual_high,
    changed.usual_width AS usual_width,
    changed.hi_limit AS hi_limit,
    changed.seen AS seen,
    CAST(SUM(changed.seen) OVER (PARTITION BY changed.support_id, changed.rung) AS BIGINT) AS seen_both_ways
  FROM (
    SELECT
      tried.support_id AS support_id,
      tried.change_name AS change_name,
      change.rung AS rung,
      middle.q05 AS usual_low,
      middle.q50 AS usual_middle,
      middle.q95 AS usual_high,
      middle.width AS usual_width,
      :hi_limit AS hi_limit,
      CAST(
        CASE
          WHEN tried.vectors = 0 OR :hi_limit IS NULL THEN NULL
          WHEN CAST(tried.novel AS DOUBLE) > :hi_limit * CAST(tried.vectors AS DOUBLE) THEN 1
          WHEN tried.vectors > 0 THEN 0
        END AS BIGINT
      ) AS seen
    FROM probe AS tried
    JOIN changes AS change ON change.change_no = tried.change_no
    JOIN usual AS middle ON middle.support_id = tried.support_id
    JOIN spread AS learnt ON learnt.support_id = tried.support_id
    JOIN bounds AS scale ON scale.channel_id = tried.support_id
  ) AS changed
) AS weighed
GROUP BY support_id
