-- Measured: the distances of reference vectors that seek a neighbour to every pattern in their box and
-- the boxes beside it that occurs outside the Theiler window (box-assisted search).
-- Reads:  probes, unsettled, shifts, patterns
-- A row:  one reference vector and one pattern.
-- Slots:  :coordinates  u_0 ... u_(d-1)
--         :box          the number of the box of a vector
--         :aways        away_0 ... away_(d-1), the distances by coordinate
--         :distance     made of these
SELECT channel_id, place, early_place, late_place, :distance AS distance
FROM (
  SELECT
    seeking.channel_id AS channel_id,
    seeking.place AS place,
    CASE
      WHEN pattern.first_place < seeking.place - seeking.nearby THEN pattern.first_place
    END AS early_place,
    CASE
      WHEN pattern.last_place > seeking.place + seeking.nearby THEN pattern.last_place
    END AS late_place,
    :aways
  FROM (
    SELECT
      boxed.channel_id AS channel_id,
      boxed.place AS place,
      boxed.nearby AS nearby,
      :coordinates,
      boxed.box + step.shift AS box
    FROM (
      SELECT
        probe.channel_id AS channel_id,
        probe.place AS place,
        probe.nearby AS nearby,
        :coordinates,
        :box AS box
      FROM probes AS probe
      JOIN unsettled AS waiting
        ON waiting.channel_id = probe.channel_id AND waiting.place = probe.place
      WHERE waiting.settled = 0
    ) AS boxed
    CROSS JOIN shifts AS step
  ) AS seeking
  JOIN (
    SELECT channel_id, first_place, last_place, :coordinates, :box AS box
    FROM patterns
  ) AS pattern ON pattern.channel_id = seeking.channel_id AND pattern.box = seeking.box
  WHERE pattern.first_place < seeking.place - seeking.nearby
    OR pattern.last_place > seeking.place + seeking.nearby
) AS paired
