-- Still so far: how many samples of the channel stood still, up to this one.
CAST(
  SUM(still) OVER (
    PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
  ) AS BIGINT
)
