-- Sampled: of a long calibration four stretches, spread evenly, stand for the whole where delays are compared.
-- Reads:  taught_samples, learners
-- A row:  one sample that is looked at; place numbers those of its channel.
-- Slots:  :stretch  samples of a stretch
SELECT
  channel_id,
  code,
  value,
  CAST(4 AS BIGINT) * whole_piece + stretch AS piece,
  CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY whole_place) AS BIGINT) AS place
FROM (
  SELECT
    held.channel_id AS channel_id,
    held.code AS code,
    held.value AS value,
    held.piece AS whole_piece,
    held.place AS whole_place,
    CASE
      WHEN looked.is_cut = 0 OR held.samples <= 4 * :stretch OR held.place < :stretch THEN 0
      WHEN held.place >= held.samples - :stretch THEN 3
      WHEN 3 * held.place >= 2 * (held.samples - :stretch) - 2
        AND 3 * (held.place - :stretch) < 2 * (held.samples - :stretch) - 2 THEN 2
      WHEN 3 * held.place >= held.samples - :stretch - 2
        AND 3 * (held.place - :stretch) < held.samples - :stretch - 2 THEN 1
    END AS stretch
  FROM taught_samples AS held
  JOIN (
    SELECT channel_id, MAX(learner.is_cut) AS is_cut
    FROM learners AS learner
    GROUP BY channel_id
  ) AS looked ON looked.channel_id = held.channel_id
) AS stretched
WHERE stretch IS NOT NULL
