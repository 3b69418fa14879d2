-- Lagged level: the level some samples ago, in the same run. Repeated by Python, once per lag.
-- Slots:  :lag  in samples
LAG(level, :lag) OVER (PARTITION BY channel_id, run_no ORDER BY place)
