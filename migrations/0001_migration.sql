-- Migration: which of these files were applied to this database.
CREATE TABLE IF NOT EXISTS stored_migration (
  number BIGINT NOT NULL,
  name VARCHAR NOT NULL,
  checksum VARCHAR NOT NULL,
  applied_at BIGINT NOT NULL,
  gam_version VARCHAR NOT NULL
);

COMMENT ON TABLE stored_migration
  IS 'Migrations applied to these tables, in order; gam migrate writes it';
COMMENT ON COLUMN stored_migration.number IS 'Number of the migration';
COMMENT ON COLUMN stored_migration.name IS 'What it makes or changes';
COMMENT ON COLUMN stored_migration.checksum IS 'SHA-256 of its file; a released migration never changes';
COMMENT ON COLUMN stored_migration.applied_at IS 'When it was applied, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_migration.gam_version IS 'The gam-db that applied it';
