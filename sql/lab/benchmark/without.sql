-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Without: takes the versions of an asset away, so that a monitor no longer watches it.
-- Slots:  :asset
DELETE FROM gam_state_version
WHERE channel_id IN (SELECT channel_id FROM gam_state_channel WHERE asset = :asset)
