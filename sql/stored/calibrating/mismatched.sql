-- Mismatched: the wanted versions of which what is stored is not what calibration froze.
-- Reads:  wanted, checksum_rows, stored_checksum
-- A row:  one version; a column is 1 where that part of it differs, summed = 0 where it has no checksum, or not
--         just one, or no bounds.
SELECT
  version_id,
  summed,
  support_differs,
  intervals_differ,
  figures_differ,
  range_differs,
  words_differ
FROM (
  SELECT
    wanted_version.version_id AS version_id,
    CASE WHEN paired.hit = 1 THEN paired.summed ELSE 0 END AS summed,
    CASE WHEN paired.hit = 1 THEN paired.support_differs ELSE 0 END AS support_differs,
    CASE WHEN paired.hit = 1 THEN paired.intervals_differ ELSE 0 END AS intervals_differ,
    CASE WHEN paired.hit = 1 THEN paired.figures_differ ELSE 0 END AS figures_differ,
    CASE WHEN paired.hit = 1 THEN paired.range_differs ELSE 0 END AS range_differs,
    CASE WHEN paired.hit = 1 THEN paired.words_differ ELSE 0 END AS words_differ
  FROM (
    SELECT version_id
    FROM wanted
    GROUP BY version_id
  ) AS wanted_version
  LEFT JOIN (
    SELECT
      version_id,
      CASE WHEN SUM(is_now) = 1 AND SUM(1 - is_now) = 1 THEN 1 ELSE 0 END AS summed,
      CASE WHEN MIN(cells_sum) <> MAX(cells_sum) THEN 1 ELSE 0 END AS support_differs,
      CASE WHEN MIN(intervals_sum) <> MAX(intervals_sum) THEN 1 ELSE 0 END AS intervals_differ,
      CASE WHEN MIN(figures_sum) <> MAX(figures_sum) THEN 1 ELSE 0 END AS figures_differ,
      CASE
        WHEN MIN(target_floor) <> MAX(target_floor) THEN 1
        WHEN MIN(calibrated_lo) <> MAX(calibrated_lo) OR MIN(calibrated_hi) <> MAX(calibrated_hi) THEN 1
        WHEN MIN(has_lo) <> MAX(has_lo) OR MIN(has_hi) <> MAX(has_hi) THEN 1
        ELSE 0
      END AS range_differs,
      CASE
        WHEN MIN(settings_hash) <> MAX(settings_hash) OR MIN(method_hash) <> MAX(method_hash) THEN 1
        ELSE 0
      END AS words_differ,
      1 AS hit
    FROM (
      SELECT
        version_id,
        cells_sum,
        intervals_sum,
        figures_sum,
        calibrated_lo,
        calibrated_hi,
        CASE WHEN calibrated_lo IS NULL THEN 0 ELSE 1 END AS has_lo,
        CASE WHEN calibrated_hi IS NULL THEN 0 ELSE 1 END AS has_hi,
        target_floor,
        settings_hash,
        method_hash,
        1 AS is_now
      FROM checksum_rows
      UNION ALL
      SELECT
        version_id,
        cells_sum,
        intervals_sum,
        figures_sum,
        calibrated_lo,
        calibrated_hi,
        CASE WHEN calibrated_lo IS NULL THEN 0 ELSE 1 END AS has_lo,
        CASE WHEN calibrated_hi IS NULL THEN 0 ELSE 1 END AS has_hi,
        target_floor,
        settings_hash,
        method_hash,
        0 AS is_now
      FROM stored_checksum
    ) AS both_sides
    GROUP BY version_id
  ) AS paired ON paired.version_id = wanted_version.version_id
) AS compared
WHERE summed = 0
  OR support_differs + intervals_differ + figures_differ + range_differs + words_differ > 0
