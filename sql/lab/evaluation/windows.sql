-- Windows: the moments of the level over the window of each value, about the window's centre.
-- moment_2 is the one against the second orthogonal polynomial of the window, 3 j^2 - h (h + 1).
-- Reads:  prefixes
-- A row:  one value; j is its distance from the centre, h the half width.
SELECT
  series_id,
  value_no,
  k,
  h,
  j,
  level_deviation,
  window_0 AS moment_0,
  window_1 - centre * window_0 AS moment_1,
  3 * (window_2 - 2 * centre * window_1 + centre * centre * window_0) - h * (h + 1) * window_0
    AS moment_2
FROM (
  SELECT
    value.series_id AS series_id,
    value.value_no AS value_no,
    value.k AS k,
    value.half_width AS h,
    value.value_no - value.centre_no AS j,
    value.level_deviation AS level_deviation,
    value.place - (value.value_no - value.centre_no) AS centre,
    newest.sum_0 - oldest.sum_0 + oldest.level_deviation AS window_0,
    newest.sum_1 - oldest.sum_1 + oldest.place * oldest.level_deviation AS window_1,
    newest.sum_2 - oldest.sum_2 + oldest.place * oldest.place * oldest.level_deviation AS window_2
  FROM (
    SELECT
      series_id,
      value_no,
      k,
      half_width,
      place,
      level_deviation,
      centre_no,
      value_key - value_no + centre_no - half_width AS oldest_key,
      value_key - value_no + centre_no + half_width AS newest_key
    FROM prefixes
  ) AS value
  JOIN prefixes AS oldest ON oldest.value_key = value.oldest_key
  JOIN prefixes AS newest ON newest.value_key = value.newest_key
) AS summed
