-- Measured: how far reference vectors that seek a neighbour, or found one in this round, are from every
-- pattern in their box and the boxes beside it that occurs outside the Theiler window (box-assisted search).
-- Reads:  probes, sought, shifts, patterns
-- A row:  one reference vector and one pattern; square is the squared Euclidean distance, largest the
--         one in the maximum norm. Early and late places are told apart by whoever reads this: on DuckDB
--         a CASE of a column that was joined must not go into another join (docs/quirks.md).
-- Slots:  :settled      0 of those that seek, 1 of those that found
--         :coordinates  u_0 ... u_(d-1)
--         :box          the number of the box of a vector
--         :aways        away_0 ... away_(d-1), the distances by coordinate
--         :square, :largest  made of these
SELECT
  channel_id,
  place,
  nearby,
  first_place,
  last_place,
  :square AS square,
  :largest AS largest
FROM (
  SELECT
    seeking.channel_id AS channel_id,
    seeking.place AS place,
    seeking.nearby AS nearby,
    pattern.first_place AS first_place,
    pattern.last_place AS last_place,
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
      JOIN sought AS waiting
        ON waiting.channel_id = probe.channel_id AND waiting.place = probe.place
      WHERE waiting.settled = :settled
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
