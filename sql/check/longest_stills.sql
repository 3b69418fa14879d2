-- Longest stills: the longest stretch of samples of one and the same value. Only channels in which a value
-- stays at all pay for this.
-- Reads:  samples, movements
-- A row:  one channel in which two samples in a row are equal.
SELECT
  stretched.channel_id AS channel_id,
  MAX(CASE WHEN stretched.still = 1 THEN stretched.position - stretched.still_from + 1 END)
    AS longest_still
FROM (
  SELECT
    compared.channel_id AS channel_id,
    compared.position AS position,
    compared.still AS still,
    MAX(CASE WHEN compared.still = 0 THEN compared.position END) OVER (
      PARTITION BY compared.channel_id
      ORDER BY compared.position
      ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS still_from
  FROM (
    SELECT
      beside.channel_id AS channel_id,
      beside.position AS position,
      CASE
        WHEN beside.position > 1 AND beside.value = beside.previous_value THEN 1
        ELSE 0
      END AS still
    FROM (
      SELECT
        sampled.channel_id AS channel_id,
        sampled.value AS value,
        CAST(
          ROW_NUMBER() OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time) AS BIGINT
        ) AS position,
        LAG(sampled.value, 1) OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time)
          AS previous_value
      FROM samples AS sampled
      JOIN movements AS movement ON movement.channel_id = sampled.channel_id
      WHERE movement.stills > 0
    ) AS beside
  ) AS compared
) AS stretched
GROUP BY stretched.channel_id
