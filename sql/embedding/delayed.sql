-- Delayed: one coordinate of the delay vector (Eq. 1): the value of a column some samples ago.
-- Repeated by Python, once per delay.
-- Slots:  :column  code, or a mark that travels with it
--         :delay   k * tau, in samples
LAG(:column, :delay) OVER (PARTITION BY channel_id ORDER BY time)
