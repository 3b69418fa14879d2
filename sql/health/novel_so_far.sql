-- Novel so far: how many of the scored vectors of a channel are novel, up to this one.
CAST(
  SUM(vector.novel) OVER (
    PARTITION BY vector.channel_id
    ORDER BY vector.time
    ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
  ) AS BIGINT
)
