-- Banded: where the signal was in scored windows that are read again, by the newest coordinate.
-- Reads:  scored_vectors, cohort
-- A row:  one band of one window, numbered from 0 as it is read.
-- Slots:  :window  W, in vectors
--         :band    the expression of alarms/band.sql
SELECT
  member.version_id AS version_id,
  counted.window_no AS window_no,
  counted.band AS band,
  counted.visits AS visits,
  counted.novel AS novel
FROM (
  SELECT
    channel_id,
    window_no,
    band,
    CAST(COUNT(*) AS BIGINT) AS visits,
    CAST(SUM(vectors.novel) AS BIGINT) AS novel
  FROM (
    SELECT
      visit.channel_id AS channel_id,
      CAST(
        FLOOR((CAST(visit.number AS DOUBLE) - CAST(5e-1 AS DOUBLE)) / CAST(:window AS DOUBLE)) AS BIGINT
      ) AS window_no,
      :band AS band,
      visit.novel AS novel
    FROM scored_vectors AS visit
  ) AS vectors
  GROUP BY channel_id, window_no, band
) AS counted
JOIN cohort AS member ON member.channel_id = counted.channel_id
