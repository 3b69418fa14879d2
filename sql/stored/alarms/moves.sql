-- Moves: the changes of a whole signal, x' = factor * x + displacement, that bring its usual values to those of a window:
-- shift by the middle ones, scale by their ratio, both by the low and the high ones, mirror likewise upside down. A shift
-- or a scale that leaves the width less than half or more than twice what it should be is no move of the whole: a frozen
-- sensor has none. Values so large or small that a quotient might leave the range of doubles have none, either.
-- Reads:  reread_usual, cohort, stored_bounds
-- A row:  one move of one window; none is always there, and leaves all as it is.
SELECT channel_id, support_id, window_no, lo, hi, move_no, factor, displacement
FROM (
  SELECT
    channel_id,
    support_id,
    window_no,
    lo,
    hi,
    move_no,
    factor,
    width,
    width_now,
    CASE move_no
      WHEN 1 THEN q50 - middle
      WHEN 3 THEN q05 - factor * low
      WHEN 4 THEN q05 - factor * high
      ELSE CAST(0 AS DOUBLE)
    END AS displacement
  FROM (
    SELECT
      quantiles.channel_id AS channel_id,
      quantiles.support_id AS support_id,
      quantiles.window_no AS window_no,
      quantiles.lo AS lo,
      quantiles.hi AS hi,
      quantiles.q05 AS q05,
      quantiles.q50 AS q50,
      quantiles.low AS low,
      quantiles.middle AS middle,
      quantiles.high AS high,
      quantiles.high - quantiles.low AS width,
      quantiles.q95 - quantiles.q05 AS width_now,
      move.move_no AS move_no,
      CASE
        WHEN move.move_no = 0 THEN CAST(1 AS DOUBLE)
        WHEN quantiles.high - quantiles.low BETWEEN CAST(1e-100 AS DOUBLE) AND CAST(1e100 AS DOUBLE)
          AND quantiles.q95 - quantiles.q05 BETWEEN CAST(1e-100 AS DOUBLE) AND CAST(1e100 AS DOUBLE)
          THEN CASE move.move_no
            WHEN 1 THEN CAST(1 AS DOUBLE)
            WHEN 2
              THEN CASE
                WHEN ABS(quantiles.middle) BETWEEN CAST(1e-100 AS DOUBLE) AND CAST(1e100 AS DOUBLE)
                  AND ABS(quantiles.q50) BETWEEN CAST(1e-100 AS DOUBLE) AND CAST(1e100 AS DOUBLE)
                  THEN quantiles.q50 / quantiles.middle
              END
            WHEN 3 THEN (quantiles.q95 - quantiles.q05) / (quantiles.high - quantiles.low)
            WHEN 4 THEN -((quantiles.q95 - quantiles.q05) / (quantiles.high - quantiles.low))
          END
      END AS factor
    FROM (
      SELECT
        member.channel_id AS channel_id,
        member.support_id AS support_id,
        member.lo AS lo,
        member.hi AS hi,
        part.window_no AS window_no,
        part.q05 AS q05,
        part.q50 AS q50,
        part.q95 AS q95,
        CASE WHEN ABS(learnt.usual_low) < CAST(1e-200 AS DOUBLE) THEN CAST(0 AS DOUBLE) ELSE learnt.usual_low END AS low,
        learnt.usual_middle AS middle,
        CASE WHEN ABS(learnt.usual_high) < CAST(1e-200 AS DOUBLE) THEN CAST(0 AS DOUBLE) ELSE learnt.usual_high END
          AS high
      FROM reread_usual AS part
      JOIN cohort AS member ON member.channel_id = part.channel_id
      JOIN stored_bounds AS learnt ON learnt.support_id = member.support_id
    ) AS quantiles
    CROSS JOIN (
      SELECT 0 AS move_no
      UNION ALL
      SELECT 1 AS move_no
      UNION ALL
      SELECT 2 AS move_no
      UNION ALL
      SELECT 3 AS move_no
      UNION ALL
      SELECT 4 AS move_no
    ) AS move
  ) AS weighed
  WHERE ABS(factor) BETWEEN CAST(1e-6 AS DOUBLE) AND CAST(1e6 AS DOUBLE)
) AS moved
WHERE move_no = 0
  OR width_now BETWEEN CAST(5e-1 AS DOUBLE) * ABS(factor) * width AND CAST(2 AS DOUBLE) * ABS(factor) * width
