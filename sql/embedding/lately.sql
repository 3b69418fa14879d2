-- Lately: how many of the samples up to this one, so many of them, are of a kind.
-- Slots:  :is_such  1 if a sample is of the kind, else 0
--         :before   samples before this one
CAST(
  SUM(:is_such) OVER (PARTITION BY channel_id ORDER BY time ROWS BETWEEN :before PRECEDING AND CURRENT ROW)
  AS BIGINT
)
