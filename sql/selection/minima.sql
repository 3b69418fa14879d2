-- Minima: the lags at which mutual information has a local minimum, I(tau - 1) > I(tau) <= I(tau + 1),
-- reached from information that is more than chance; at tau = 1 its own must be. Other minima are
-- ripples of noise.
-- Reads:  curve
-- A row:  one minimum of one channel.
SELECT channel_id, delay - 1 AS tau
FROM (
  SELECT
    channel_id,
    delay,
    ami,
    CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY delay) AS BIGINT) AS place,
    LAG(ami, 1) OVER (PARTITION BY channel_id ORDER BY delay) AS ami_at,
    LAG(ami, 2) OVER (PARTITION BY channel_id ORDER BY delay) AS ami_before,
    LAG(informative, 1) OVER (PARTITION BY channel_id ORDER BY delay) AS informative_at,
    LAG(informative, 2) OVER (PARTITION BY channel_id ORDER BY delay) AS informative_before
  FROM curve
) AS lagging
WHERE place > 2
  AND ami_before > ami_at
  AND ami_at <= ami
  AND CASE WHEN delay = 2 THEN informative_at ELSE informative_before END = 1
