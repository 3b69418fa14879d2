-- Whole range: the least and greatest calibration value of each support, over all members of a pool.
-- Reads:  calibrated, channels
-- A row:  one support whose calibration has a value. allowed is how many samples may be dropped, NULL until they are
--         counted.
-- Slots:  :settings_no  the set of parameters that this step serves
SELECT
  named.support_id AS support_id,
  MIN(seen.lowest) AS lo,
  MAX(seen.highest) AS hi,
  CAST(NULL AS BIGINT) AS allowed,
  CAST(0 AS BIGINT) AS dropped_below,
  CAST(0 AS BIGINT) AS dropped_above
FROM calibrated AS seen
JOIN channels AS named ON named.channel_id = seen.channel_id
WHERE seen.lowest IS NOT NULL AND named.settings_no = :settings_no
GROUP BY named.support_id
