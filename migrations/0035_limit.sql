-- Limit: what judgements of a version are judged by, or why they are not. Frozen: a new row replaces an older one
-- from a judgement on.
CREATE TABLE IF NOT EXISTS stored_limit (
  version_id BIGINT NOT NULL,
  limit_no BIGINT NOT NULL,
  from_judgement BIGINT NOT NULL,
  created BIGINT NOT NULL,
  cause VARCHAR NOT NULL,
  asked VARCHAR NOT NULL,
  family BIGINT NOT NULL,
  blocks BIGINT NOT NULL,
  g BIGINT NOT NULL,
  centre BIGINT,
  spread BIGINT,
  reference BIGINT,
  height BIGINT,
  cap BIGINT,
  quarters BIGINT,
  basis VARCHAR,
  order_ratio BIGINT,
  judgements_per_day DOUBLE,
  rate DOUBLE,
  stated_rate DOUBLE,
  reason VARCHAR
);

COMMENT ON TABLE stored_limit
  IS 'What the judgements of a version are judged by; one row per version and time that limits were made';
COMMENT ON COLUMN stored_limit.version_id IS 'The version';
COMMENT ON COLUMN stored_limit.limit_no
  IS '1, 2, ... within the version; the newest that begins at or before a judgement counts';
COMMENT ON COLUMN stored_limit.from_judgement IS 'First judgement that it is for';
COMMENT ON COLUMN stored_limit.created IS 'When it was made, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_limit.cause IS 'Why it was made: calibrated, or what was said then';
COMMENT ON COLUMN stored_limit.asked IS 'The false alarms that were asked for';
COMMENT ON COLUMN stored_limit.family IS 'Channels of the same number were made together, as alike; from 0';
COMMENT ON COLUMN stored_limit.blocks IS 'Blocks of calibration of a window or more';
COMMENT ON COLUMN stored_limit.g IS 'Blocks up to so far away did not vouch for a cell';
COMMENT ON COLUMN stored_limit.centre
  IS 'Mean root of the blocks, in thousandths; NULL where there is no limit, as all that follows';
COMMENT ON COLUMN stored_limit.spread IS 'Their standard deviation, likewise';
COMMENT ON COLUMN stored_limit.reference IS 'Root above which a judgement is raised: centre + spread';
COMMENT ON COLUMN stored_limit.height IS 'Evidence that opens an episode';
COMMENT ON COLUMN stored_limit.cap IS 'The most that one judgement adds to evidence';
COMMENT ON COLUMN stored_limit.quarters IS 'The height in quarters of a spread';
COMMENT ON COLUMN stored_limit.basis IS 'What the height rests on: replay, extrapolated, table, drifting or none';
COMMENT ON COLUMN stored_limit.order_ratio IS 'As in extent; NULL with fewer than 18 blocks';
COMMENT ON COLUMN stored_limit.judgements_per_day
  IS 'Judgements a day in calibration; NULL where the source counts time';
COMMENT ON COLUMN stored_limit.rate IS 'False alarms asked for, per judgement';
COMMENT ON COLUMN stored_limit.stated_rate
  IS 'Those that the height is for, at least 0.0005; NULL where none can be stated';
COMMENT ON COLUMN stored_limit.reason IS 'Why there is no limit; NULL where there is one';
