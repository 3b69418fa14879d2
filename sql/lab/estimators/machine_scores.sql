-- Machine scores: One-Class SVM with radial basis functions: less the sum of weight * exp(-gamma d^2) over
-- the support vectors, d the distance to each. Summed in integers: weights come in units of which all
-- together fit into 64 bits, unit is the size of one, a power of two.
-- Reads:  scored_points, machine_vectors
-- A row:  one scored vector.
-- Slots:  :squared_distance  d^2
SELECT
  channel_id,
  time,
  -CAST(
    SUM(
      CAST(
        FLOOR(
          CASE
            WHEN gamma_distance < CAST(7e2 AS DOUBLE) THEN weight * EXP(-gamma_distance)
            ELSE CAST(0 AS DOUBLE)
          END + CAST(5e-1 AS DOUBLE)
        ) AS BIGINT
      )
    ) AS DOUBLE
  ) * unit AS score
FROM (
  SELECT
    vector.channel_id AS channel_id,
    vector.time AS time,
    fitted.weight AS weight,
    fitted.unit AS unit,
    fitted.gamma * (:squared_distance) AS gamma_distance
  FROM scored_points AS vector
  JOIN machine_vectors AS fitted ON fitted.support_id = vector.support_id
) AS compared
GROUP BY channel_id, time, unit
