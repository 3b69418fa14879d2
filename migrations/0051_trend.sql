-- Trend: how far the indicator of each channel moved from the window before the last to the last one, and whether
-- that is a rise to be told while the channel is not above its limit: by more than 0.01 and two standard deviations of the blocks
-- of calibration, to more than half of hi_limit.
CREATE OR REPLACE VIEW stored_trend AS
SELECT
  moved.monitor AS monitor,
  moved.asset AS asset,
  moved.channel AS channel,
  moved.version_no AS version_no,
  moved.version_id AS version_id,
  moved.rise AS rise,
  CASE
    WHEN moved.is_above IS NULL OR moved.is_above = 1 OR moved.rise IS NULL THEN 0
    WHEN moved.floor_sd IS NOT NULL AND moved.rise <= 2 * moved.floor_sd THEN 0
    WHEN moved.rise > CAST(1e-2 AS DOUBLE) AND moved.hi > moved.hi_limit / CAST(2 AS DOUBLE) THEN 1
    ELSE 0
  END AS is_rising
FROM (
  SELECT
    known.monitor AS monitor,
    known.asset AS asset,
    known.channel AS channel,
    known.version_no AS version_no,
    known.version_id AS version_id,
    known.is_above AS is_above,
    known.floor_sd AS floor_sd,
    known.hi_limit AS hi_limit,
    known.hi AS hi,
    CAST(known.novel_in_window - known.novel_window_before AS DOUBLE) / CAST(known.window_length AS DOUBLE)
      AS rise
  FROM stored_fleet AS known
) AS moved;

COMMENT ON VIEW stored_trend IS 'Whether the indicator of each channel rises that is not above its limit; one row per channel';
COMMENT ON COLUMN stored_trend.monitor IS 'The monitor';
COMMENT ON COLUMN stored_trend.asset IS 'The machine';
COMMENT ON COLUMN stored_trend.channel IS 'The signal';
COMMENT ON COLUMN stored_trend.version_no IS 'Which calibration of the channel: 1, 2, ...; the active one';
COMMENT ON COLUMN stored_trend.version_id IS 'Its key in the other tables';
COMMENT ON COLUMN stored_trend.rise
  IS 'hi less that of the window before the last; NULL until two windows are scored';
COMMENT ON COLUMN stored_trend.is_rising
  IS '1 if it is not above its limit, and hi above half of hi_limit and risen by more than 0.01 and twice floor_sd; else 0';
