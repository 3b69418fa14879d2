-- Piece: which piece of calibration a sample lies in: a new one begins after a sample that is not of calibration, and
-- with a new segment.
-- Slots:  :parted  whether a sample parts those before from those after it
CAST(
  SUM(CASE WHEN :parted THEN 1 ELSE 0 END) OVER (
    PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
  ) AS BIGINT
)
