-- Novel so far: how many of the scored vectors of a channel are novel, up to this one.
CAST(
  SUM(CASE WHEN vector.novel = 1 THEN 1 ELSE 0 END) OVER (
    PARTITION BY vector.channel_id
    ORDER BY vector.time
    ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
  ) AS BIGINT
)
