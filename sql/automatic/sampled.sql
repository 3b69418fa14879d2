-- Sampled: of a long calibration four stretches, spread evenly, stand for the whole where delays are compared.
-- Reads:  taught_samples, learners
-- A row:  one sample that is looked at; place numbers those of its channel.
-- Slots:  :stretch  samples of a stretch
SELECT
  channel_id,
  code,
  value,
  CAST(4 AS BIGINT) * piece + stretch AS piece,
  CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY place) AS BIGINT) AS place
FROM (
  SELECT
    sample.channel_id AS channel_id,
    sample.code AS code,
    sample.value AS value,
    sample.piece AS piece,
    sample.place AS place,
    CASE
      WHEN looked.is_cut = 0 OR sample.samples <= 4 * :stretch OR sample.place < :stretch THEN 0
      WHEN sample.place >= sample.samples - :stretch THEN 3
      WHEN 3 * sample.place >= 2 * (sample.samples - :stretch) - 2
        AND 3 * (sample.place - :stretch) < 2 * (sample.samples - :stretch) - 2 THEN 2
      WHEN 3 * sample.place >= sample.samples - :stretch - 2
        AND 3 * (sample.place - :stretch) < sample.samples - :stretch - 2 THEN 1
    END AS stretch
  FROM taught_samples AS sample
  JOIN (
    SELECT channel_id, MAX(learner.is_cut) AS is_cut
    FROM learners AS learner
    GROUP BY channel_id
  ) AS looked ON looked.channel_id = sample.channel_id
) AS stretched
WHERE stretch IS NOT NULL
