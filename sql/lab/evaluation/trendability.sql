-- Trendability: the smallest likeness of any two failed assets of a drawing (Coble and Hines 2009), NULL
-- where that of one pair is.
-- Reads:  life_pairs, drawings
-- A row:  one drawing with two failed assets or more.
SELECT
  drawing_row.drawing AS drawing,
  CASE
    WHEN CAST(COUNT(pair.likeness) AS BIGINT) = CAST(COUNT(*) AS BIGINT) THEN MIN(pair.likeness)
  END AS trendability
FROM life_pairs AS pair
JOIN drawings AS drawing_row ON drawing_row.asset_no = pair.asset_no
JOIN drawings AS other ON other.asset_no = pair.other_no AND other.drawing = drawing_row.drawing
WHERE drawing_row.stratum = 0 AND other.stratum = 0
GROUP BY drawing_row.drawing
