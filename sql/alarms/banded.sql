-- Banded: where calibration was, by the newest coordinate (alarms, section 5).
-- Reads:  visits, bounds
-- A row:  one band of one channel that calibration visited.
-- Slots:  :band  the expression of alarms/band.sql
SELECT channel_id, band, CAST(SUM(band_visit.visits) AS BIGINT) AS visits
FROM (
  SELECT visit.channel_id AS channel_id, :band AS band, visit.visits AS visits
  FROM visits AS visit
  JOIN bounds AS scale ON scale.channel_id = visit.channel_id
) AS band_visit
GROUP BY channel_id, band
