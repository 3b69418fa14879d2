-- Checksum rows: what calibration froze, in sums of integers, and what is no integer as it is. It finds damage
-- and slips; whoever forges a table can forge its sum. With p = 2^31 - 1, mixed makes one integer below p of two,
-- so that a sum of such is a checksum that all engines add to the same, in any order: with
-- x = ((number mod p) * 31 + place + 1) mod p it is x^2 mod p. An integer that is NULL adds nothing.
-- Reads:  frozen, stored_bounds, stored_support, stored_calibration
-- A row:  one version that has bounds.
CREATE OR REPLACE MACRO mixed(number, place) AS (
  (((number % 2147483647) * 31 + place + 1) % 2147483647)
  * (((number % 2147483647) * 31 + place + 1) % 2147483647)
) % 2147483647;

CREATE OR REPLACE MACRO figure(number, place) AS
  CASE WHEN number IS NOT NULL THEN mixed(number, place) ELSE 0 END;

SELECT
  learnt.version_id AS version_id,
  CASE WHEN held.hit = 1 THEN held.cells_sum ELSE 0 END AS cells_sum,
  CASE WHEN healthy.hit = 1 THEN healthy.intervals_sum ELSE 0 END AS intervals_sum,
  figure(learnt.channel_id, 0)
    + figure(learnt.support_id, 1)
    + figure(learnt.parent_id, 2)
    + figure(learnt.version_no, 3)
    + figure(learnt.m, 4)
    + figure(learnt.tau, 5)
    + figure(learnt.bins, 6)
    + figure(learnt.window_length, 7)
    + figure(learnt.stride, 8)
    + figure(learnt.max_gap, 9)
    + figure(learnt.score_from, 10)
    + figure(learnt.calibration_end, 11)
    + figure(learnt.first_scored, 12)
    + figure(learnt.run_up_from, 13)
    + figure(learnt.calibration_readings, 14)
    + figure(learnt.calibration_samples, 15)
    + figure(learnt.created, 16)
    + figure(scale.calibration_vectors, 17)
    + figure(scale.cells, 18)
    + figure(scale.seen_once, 19)
    + figure(scale.blocks, 20)
    + figure(scale.finest_bins, 21)
    + figure(scale.vectors_needed, 22)
    + figure(learnt.still_after, 23)
    + figure(learnt.least_vectors, 24) AS figures_sum,
  scale.calibrated_lo AS calibrated_lo,
  scale.calibrated_hi AS calibrated_hi,
  learnt.target_floor AS target_floor,
  learnt.settings_hash AS settings_hash,
  learnt.method_hash AS method_hash
FROM frozen AS learnt
JOIN stored_bounds AS scale ON scale.support_id = learnt.support_id
LEFT JOIN (
  SELECT
    cell.support_id AS support_id,
    CAST(SUM(mixed(cell.cell_key, cell.visits)) AS BIGINT) AS cells_sum,
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
    CAST(SUM(mixed(piece.time_from, piece.time_to % 2147483647)) AS BIGINT) AS intervals_sum,
    1 AS hit
  FROM stored_calibration AS piece
  GROUP BY piece.version_id
) AS healthy ON healthy.version_id = learnt.version_id
