-- Clock: when a scheduled run began, and the latest instant of a row that counts.
-- A row:  the only one.
-- Slots:  :now     this instant, in microseconds since 1970 (UTC)
--         :latest  the latest instant of a row that counts, in the unit of time
SELECT
  CAST(:now AS BIGINT) AS started,
  CAST(:latest AS BIGINT) AS latest
