-- Still so far: how many samples of the channel stood still, up to this one.
CAST(
  SUM(CASE WHEN still = 1 THEN 1 ELSE 0 END) OVER (
    PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
  ) AS BIGINT
)
