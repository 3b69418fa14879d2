-- Unplaced, by day: what runs could give to no channel or instant. Ranges of runs overlap, and a row counts
-- in each that reads it: so it is the most that one run of the day found, not a sum. Runs that only held readings to a
-- condition are none of them.
CREATE OR REPLACE VIEW stored_unplaced_day AS
SELECT
  watching.name AS monitor,
  MAKE_TIMESTAMP(found.day_start) AS day,
  CAST(COUNT(*) AS BIGINT) AS runs,
  MAX(found.nameless) AS nameless,
  MAX(found.undated) AS undated,
  MAX(found.strangers) AS strangers,
  MAX(found.stranger_channels) AS stranger_channels
FROM (
  SELECT
    run.monitor_id AS monitor_id,
    CAST(
      FLOOR(
        (CAST(run.started AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(86400000000 AS DOUBLE)
      ) AS BIGINT
    ) * 86400000000 AS day_start,
    run.nameless AS nameless,
    run.undated AS undated,
    run.strangers AS strangers,
    run.stranger_channels AS stranger_channels
  FROM stored_unplaced AS run
  WHERE run.nameless > 0 OR run.undated > 0 OR run.strangers > 0
) AS found
JOIN stored_monitor AS watching ON watching.monitor_id = found.monitor_id
GROUP BY watching.name, found.day_start;

COMMENT ON VIEW stored_unplaced_day
  IS 'Rows that runs could give to no channel or instant, by day: the most that one run found';
COMMENT ON COLUMN stored_unplaced_day.monitor IS 'The monitor';
COMMENT ON COLUMN stored_unplaced_day.day IS 'The day on which the runs began (UTC)';
COMMENT ON COLUMN stored_unplaced_day.runs IS 'Runs of the day that found any';
COMMENT ON COLUMN stored_unplaced_day.nameless IS 'Rows without asset or channel';
COMMENT ON COLUMN stored_unplaced_day.undated IS 'Rows without a time';
COMMENT ON COLUMN stored_unplaced_day.strangers IS 'Rows of channels that have no calibration';
COMMENT ON COLUMN stored_unplaced_day.stranger_channels IS 'How many such channels there were';
