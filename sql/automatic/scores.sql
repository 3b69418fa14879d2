-- Scores: how much would be seen if the machine changed, in thousandths of what is seen at once: the mean over changes
-- of how far each would lie above twice the limit, 1000 at most (both sides, section 4).
-- Reads:  passing, changed, grids
-- A row:  one grid of one support that passes, finest first.
-- Slots:  :coarse_key  the key of a cell on the coarser grid
SELECT
  good.support_id AS support_id,
  good.level AS level,
  CAST(CASE WHEN grid_score.hit = 1 THEN grid_score.score ELSE 0 END AS BIGINT) AS score
FROM passing AS good
LEFT JOIN (
  SELECT
    support_id,
    level,
    FLOOR(
      (CAST(CAST(SUM(points) AS BIGINT) AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(COUNT(*) AS DOUBLE)
    ) AS score,
    1 AS hit
  FROM (
    SELECT
      support_id,
      level,
      CASE
        WHEN novel = 0 THEN CAST(0 AS BIGINT)
        WHEN CAST(500 AS DOUBLE) * CAST(novel AS DOUBLE)
          / NULLIF(CAST(changed_vectors AS DOUBLE) * hi_limit, CAST(0 AS DOUBLE))
          < CAST(1000 AS DOUBLE)
          THEN CAST(
            FLOOR(CAST(500 AS DOUBLE) * CAST(novel AS DOUBLE) / (CAST(changed_vectors AS DOUBLE) * hi_limit)) AS BIGINT
          )
        ELSE CAST(1000 AS BIGINT)
      END AS points
    FROM (
      SELECT
        moved.support_id AS support_id,
        moved.level AS level,
        moved.change_no AS change_no,
        MIN(moved.hi_limit) AS hi_limit,
        CAST(COUNT(*) AS BIGINT) AS changed_vectors,
        CAST(
          SUM(
            CASE
              WHEN healthy.hit = 1
                AND (healthy.first_block < healthy.last_block OR healthy.first_block <> moved.block)
                THEN 0
              ELSE 1
            END
          ) AS BIGINT
        ) AS novel
      FROM (
        SELECT
          vector.support_id AS support_id,
          vector.change_no AS change_no,
          vector.block AS block,
          grid.level AS level,
          grid.hi_limit AS hi_limit,
          :coarse_key AS cell_key
        FROM changed AS vector
        JOIN passing AS grid ON grid.support_id = vector.support_id
      ) AS moved
      LEFT JOIN (
        SELECT support_id, level, cell_key, first_block, last_block, 1 AS hit
        FROM grids
      ) AS healthy
        ON healthy.support_id = moved.support_id
        AND healthy.level = moved.level
        AND healthy.cell_key = moved.cell_key
      GROUP BY moved.support_id, moved.level, moved.change_no
    ) AS counted
  ) AS pointed
  GROUP BY support_id, level
) AS grid_score ON grid_score.support_id = good.support_id AND grid_score.level = good.level
ORDER BY good.support_id, good.level
