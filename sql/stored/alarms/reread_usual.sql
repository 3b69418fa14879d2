-- Reread usual: between which values a signal lay in each window that is read again, by the ranks of probe/usual.sql.
-- Reads:  reread
-- A row:  one window.
SELECT
  channel_id,
  window_no,
  MAX(
    CASE
      WHEN ranked.place = FLOOR((CAST(ranked.vectors + 19 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(20 AS DOUBLE))
        THEN ranked.value
    END
  ) AS q05,
  MAX(
    CASE
      WHEN ranked.place = FLOOR((CAST(ranked.vectors + 1 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(2 AS DOUBLE))
        THEN ranked.value
    END
  ) AS q50,
  MAX(
    CASE
      WHEN ranked.vectors - ranked.place
        = FLOOR((CAST(ranked.vectors AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(20 AS DOUBLE))
        THEN ranked.value
    END
  ) AS q95
FROM (
  SELECT
    channel_id,
    window_no,
    x_0 AS value,
    CAST(COUNT(*) OVER (PARTITION BY channel_id, window_no) AS BIGINT) AS vectors,
    CAST(ROW_NUMBER() OVER (PARTITION BY channel_id, window_no ORDER BY x_0) AS BIGINT) AS place
  FROM reread
) AS ranked
GROUP BY channel_id, window_no
