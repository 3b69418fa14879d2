-- False neighbours (Kennel, Brown and Abarbanel 1992) at d coordinates: those that the next coordinate
-- parts by more than Rtol = 15 times their distance, or to more than Atol = 2 standard deviations of
-- the series. Distances are squared, and in units of 2^-24 of the range.
-- Reads:  probes, followed, deviations
-- A row:  one channel; skipped counts the neighbours found beyond others at distance zero.
-- Slots:  :d  coordinates
SELECT
  probe.channel_id AS channel_id,
  CAST(:d AS INTEGER) AS m,
  CAST(COUNT(*) AS BIGINT) AS reference_vectors,
  CAST(SUM(CASE WHEN pair.hit = 1 THEN 1 ELSE 0 END) AS BIGINT) AS neighbours,
  CAST(SUM(CASE WHEN pair.hit = 1 THEN pair.twin ELSE 0 END) AS BIGINT) AS skipped,
  CAST(SUM(CASE WHEN pair.hit = 1 THEN pair.is_false ELSE 0 END) AS BIGINT) AS false_neighbours
FROM probes AS probe
LEFT JOIN (
  SELECT
    going.channel_id AS channel_id,
    going.place AS place,
    going.twin AS twin,
    CASE
      WHEN going.parting * going.parting > 225 * going.distance THEN 1
      WHEN SQRT(CAST(going.distance + going.parting * going.parting AS DOUBLE))
        > CAST(33554432 AS DOUBLE) * size.deviation THEN 1
      ELSE 0
    END AS is_false,
    1 AS hit
  FROM followed AS going
  JOIN deviations AS size ON size.channel_id = going.channel_id
) AS pair ON pair.channel_id = probe.channel_id AND pair.place = probe.place
GROUP BY probe.channel_id
