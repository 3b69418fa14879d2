-- Ladder: the floor of each support on its own grid and on every coarser one that calibration tried.
CREATE TABLE IF NOT EXISTS stored_ladder (
  support_id BIGINT NOT NULL,
  bins BIGINT NOT NULL,
  floor DOUBLE NOT NULL
);

COMMENT ON TABLE stored_ladder
  IS 'Floor of healthy operation by bins per axis; one row per grid of a support; none of before this was kept';
COMMENT ON COLUMN stored_ladder.support_id IS 'The support';
COMMENT ON COLUMN stored_ladder.bins IS 'Bins per axis: those of the version, then half of them, and so on';
COMMENT ON COLUMN stored_ladder.floor IS 'Expected health indicator of healthy operation on that grid';
