-- Checksum rows: what calibration froze, in sums of integers, and what is no integer as it is. It finds damage
-- and slips; whoever forges a table can forge its sum. With p = 2^31 - 1, mixed makes one integer below p of two,
-- so that a sum of such is a checksum that all engines add to the same, in any order: with
-- x = ((number mod p) * 31 + place + 1) mod p it is x^2 mod p. An integer that is NULL adds nothing. (x of
-- each figure is made in a query below, so that it is planned once: this is asked in every run.)
-- Reads:  frozen, stored_bounds, stored_support, stored_calibration
-- A row:  one version that has bounds.
CREATE OR REPLACE MACRO reduced(number, place) AS ((number % 2147483647) * 31 + place + 1) % 2147483647;

CREATE OR REPLACE MACRO mixed(number, place) AS (reduced(number, place) * reduced(number, place)) % 2147483647;

CREATE OR REPLACE MACRO figure(x) AS CASE WHEN x IS NOT NULL THEN (x * x) % 2147483647 ELSE 0 END;

SELECT
  version_id,
  cells_sum,
  intervals_sum,
  figure(channel_id)
    + figure(support_id)
    + figure(parent_id)
    + figure(version_no)
    + figure(m)
    + figure(tau)
    + figure(bins)
    + figure(window_length)
    + figure(stride)
    + figure(max_gap)
    + figure(score_from)
    + figure(calibration_end)
    + figure(first_scored)
    + figure(run_up_from)
    + figure(calibration_readings)
    + figure(calibration_samples)
    + figure(created)
    + figure(calibration_vectors)
    + figure(cells)
    + figure(seen_once)
    + figure(blocks)
    + figure(finest_bins)
    + figure(vectors_needed)
    + figure(still_after)
    + figure(least_vectors)
    + figure(is_robust)
    + figure(dropped_below)
    + figure(dropped_above)
    + figure(program_weight) AS figures_sum,
  calibrated_lo,
  calibrated_hi,
  target_floor,
  settings_hash,
  method_hash
FROM (
  SELECT
    learnt.version_id AS version_id,
    CASE WHEN held.hit = 1 THEN held.cells_sum ELSE 0 END AS cells_sum,
    CASE WHEN healthy.hit = 1 THEN healthy.intervals_sum ELSE 0 END AS intervals_sum,
    reduced(learnt.channel_id, 0) AS channel_id,
    reduced(learnt.support_id, 1) AS support_id,
    reduced(learnt.parent_id, 2) AS parent_id,
    reduced(learnt.version_no, 3) AS version_no,
    reduced(learnt.m, 4) AS m,
    reduced(learnt.tau, 5) AS tau,
    reduced(learnt.bins, 6) AS bins,
    reduced(learnt.window_length, 7) AS window_length,
    reduced(learnt.stride, 8) AS stride,
    reduced(learnt.max_gap, 9) AS max_gap,
    reduced(learnt.score_from, 10) AS score_from,
    reduced(learnt.calibration_end, 11) AS calibration_end,
    reduced(learnt.first_scored, 12) AS first_scored,
    reduced(learnt.run_up_from, 13) AS run_up_from,
    reduced(learnt.calibration_readings, 14) AS calibration_readings,
    reduced(learnt.calibration_samples, 15) AS calibration_samples,
    reduced(learnt.created, 16) AS created,
    reduced(scale.calibration_vectors, 17) AS calibration_vectors,
    reduced(scale.cells, 18) AS cells,
    reduced(scale.seen_once, 19) AS seen_once,
    reduced(scale.blocks, 20) AS blocks,
    reduced(scale.finest_bins, 21) AS finest_bins,
    reduced(scale.vectors_needed, 22) AS vectors_needed,
    reduced(learnt.still_after, 23) AS still_after,
    reduced(learnt.least_vectors, 24) AS least_vectors,
    reduced(learnt.is_robust, 25) AS is_robust,
    reduced(scale.dropped_below, 26) AS dropped_below,
    reduced(scale.dropped_above, 27) AS dropped_above,
    reduced(learnt.program_weight, 28) AS program_weight,
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
) AS terms
