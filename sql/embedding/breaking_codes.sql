-- Breaking codes: codes, with whether a segment begins with a sample.
-- Reads:  codes
-- A row:  one sample; breaking = 1 if a segment begins with it.
-- Slots:  :breaking  the expression of embedding/breaking.sql
--         :carried   columns that travel with the sample
SELECT channel_id, time, code, :breaking AS breaking, :carried
FROM codes
