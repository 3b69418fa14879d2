-- Trendability: the smallest likeness of any two failed assets of a drawing (Coble and Hines 2009), NULL
-- where that of one pair is.
-- Reads:  life_pairs, drawings
-- A row:  one drawing with two failed assets or more.
SELECT
  one.drawing AS drawing,
  CASE
    WHEN CAST(COUNT(pair.likeness) AS BIGINT) = CAST(COUNT(*) AS BIGINT) THEN MIN(pair.likeness)
  END AS trendability
FROM life_pairs AS pair
JOIN drawings AS one ON one.asset_no = pair.asset_no
JOIN drawings AS other ON other.asset_no = pair.other_no AND other.drawing = one.drawing
WHERE one.stratum = 0 AND other.stratum = 0
GROUP BY one.drawing
