-- Stand in: only so that the numbers have no gap on this branch; 0017 is another branch's.
CREATE OR REPLACE VIEW stored_stand_in AS
SELECT number AS number
FROM stored_migration;

COMMENT ON VIEW stored_stand_in IS 'Nothing';
COMMENT ON COLUMN stored_stand_in.number IS 'Nothing';
