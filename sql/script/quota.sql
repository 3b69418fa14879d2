-- Quota: how many samples are the healthy share of a channel.
-- Slots:  :fraction  the healthy share
CAST(FLOOR(:fraction * CAST(series_length AS DOUBLE)) AS BIGINT)
