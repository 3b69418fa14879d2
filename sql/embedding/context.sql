-- Context: the time of the sample so many places before, from where on a later run must read. Where samples that
-- stand still are told by those before them, there may be fewer: then it is all there is.
-- Slots:  :delay     in samples
--         :long_ago  an instant before all others
CASE
  WHEN CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) > :delay
    THEN LAG(time, :delay) OVER (PARTITION BY channel_id ORDER BY time)
  ELSE CAST(:long_ago AS BIGINT)
END
