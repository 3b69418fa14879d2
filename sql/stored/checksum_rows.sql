-- Checksum rows: what calibration froze, in sums of integers, and what is no integer as it is. It finds damage
-- and slips; whoever forges a table can forge its sum.
-- Reads:  frozen, stored_bounds, stored_support, stored_calibration
-- A row:  one version that has bounds.
-- Slots:  :cell      a cell and its visits, by stored/mixed.sql
--         :interval  the edges of an interval, by stored/mixed.sql
--         :ends      the ends of the range, under the names that the checksums have for them
--         :figures   the sum of stored/figure.sql over the integers of version and bounds
SELECT
  learnt.version_id AS version_id,
  CASE WHEN held.hit = 1 THEN held.cells_sum ELSE 0 END AS cells_sum,
  CASE WHEN healthy.hit = 1 THEN healthy.intervals_sum ELSE 0 END AS intervals_sum,
  :figures AS figures_sum,
  :ends,
  learnt.target_floor AS target_floor,
  learnt.settings_hash AS settings_hash,
  learnt.method_hash AS method_hash
FROM frozen AS learnt
JOIN stored_bounds AS scale ON scale.support_id = learnt.support_id
LEFT JOIN (
  SELECT
    cell.support_id AS support_id,
    CAST(SUM(:cell) AS BIGINT) AS cells_sum,
    1 AS hit
  FROM stored_support AS cell
  JOIN (
    SELECT support_id
    FROM frozen
    GROUP BY support_id
  ) AS needed ON needed.support_id = cell.support_id
  GROUP BY cell.support_id
) AS held ON held.support_id = learnt.support_id
LEFT JOIN (
  SELECT
    piece.version_id AS version_id,
    CAST(SUM(:interval) AS BIGINT) AS intervals_sum,
    1 AS hit
  FROM stored_calibration AS piece
  GROUP BY piece.version_id
) AS healthy ON healthy.version_id = learnt.version_id
