-- Grafana counts: what stands above the dashboard.
-- Reads:  stored_machine
-- A row:  all machines that are chosen.
-- Slots:  :monitor  its name
--         :assets   the machines that are chosen
SELECT
  CAST(COUNT(*) AS BIGINT) AS machines,
  CAST(SUM(CASE WHEN above > 0 THEN 1 ELSE 0 END) AS BIGINT) AS machines_above,
  CAST(SUM(member.signals) AS BIGINT) AS signals,
  CAST(SUM(member.above) AS BIGINT) AS signals_above,
  CAST(SUM(member.not_judged) AS BIGINT) AS signals_not_judged
FROM stored_machine AS member
WHERE monitor = :monitor AND asset IN (:assets)
