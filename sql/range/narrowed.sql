-- Narrowed: what a round leaves of the range of a support. The core begins in the first piece up to which more samples
-- lie than may be dropped, and ends likewise. What lies beyond a stretch of empty pieces at least as wide as the core
-- is dropped, unless it is more than may be.
-- Reads:  range_counts
-- A row:  one support of which this round drops samples; allowed is how many later rounds may drop.
SELECT
  support_id,
  lo,
  hi,
  permitted - dropped_below - dropped_above AS allowed,
  dropped_below,
  dropped_above
FROM (
  SELECT
    support_id,
    permitted,
    MIN(CASE WHEN piece >= COALESCE(lower_piece, 0) THEN lowest END) AS lo,
    MAX(CASE WHEN piece <= COALESCE(upper_piece, 127) THEN highest END) AS hi,
    CAST(SUM(CASE WHEN piece < lower_piece THEN samples ELSE 0 END) AS BIGINT) AS dropped_below,
    CAST(SUM(CASE WHEN piece > upper_piece THEN samples ELSE 0 END) AS BIGINT) AS dropped_above
  FROM (
    SELECT
      support_id,
      permitted,
      piece,
      samples,
      lowest,
      highest,
      MAX(CASE WHEN piece <= first_piece AND piece - piece_before > width THEN piece END)
        OVER (PARTITION BY support_id) AS lower_piece,
      MIN(CASE WHEN piece >= last_piece AND piece_after - piece > width THEN piece END)
        OVER (PARTITION BY support_id) AS upper_piece
    FROM (
      SELECT
        support_id,
        permitted,
        piece,
        samples,
        lowest,
        highest,
        piece_before,
        piece_after,
        first_piece,
        last_piece,
        CASE WHEN first_piece <= last_piece THEN last_piece - first_piece + 1 END AS width
      FROM (
        SELECT
          support_id,
          permitted,
          piece,
          samples,
          lowest,
          highest,
          piece_before,
          piece_after,
          MIN(CASE WHEN from_below > permitted THEN piece END) OVER (PARTITION BY support_id) AS first_piece,
          MAX(CASE WHEN total - from_below + samples > permitted THEN piece END)
            OVER (PARTITION BY support_id) AS last_piece
        FROM (
          SELECT
            support_id,
            CASE
              WHEN allowed IS NOT NULL THEN allowed
              WHEN total < 4000 THEN 3
              ELSE CAST(FLOOR((CAST(total AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(1000 AS DOUBLE)) AS BIGINT)
            END AS permitted,
            piece,
            samples,
            lowest,
            highest,
            total,
            from_below,
            piece_before,
            piece_after
          FROM (
            SELECT
              support_id,
              allowed,
              piece,
              samples,
              lowest,
              highest,
              CAST(SUM(samples) OVER (PARTITION BY support_id) AS BIGINT) AS total,
              CAST(
                SUM(samples) OVER (
                  PARTITION BY support_id
                  ORDER BY piece
                  ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
                ) AS BIGINT
              ) AS from_below,
              LAG(piece, 1) OVER (PARTITION BY support_id ORDER BY piece) AS piece_before,
              LAG(piece, 1) OVER (PARTITION BY support_id ORDER BY piece DESC) AS piece_after
            FROM (
              SELECT
                support_id,
                allowed,
                piece,
                CAST(SUM(part.samples) AS BIGINT) AS samples,
                MIN(part.lowest) AS lowest,
                MAX(part.highest) AS highest
              FROM range_counts AS part
              GROUP BY support_id, allowed, piece
            ) AS summed
          ) AS ordered
        ) AS counted
      ) AS cored
    ) AS widened
  ) AS cut
  GROUP BY support_id, permitted
) AS outcome
WHERE dropped_below + dropped_above BETWEEN 1 AND permitted AND lo < hi
