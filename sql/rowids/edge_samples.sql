-- Edge samples, by row: the samples of the edges, in order; as census/edge_samples.sql. For SQLite, where those of a
-- channel are the last of its rows, since rows without a time come first, and their place is known: nothing is
-- sorted. Proof: pieces, whose rows are in order.
-- Dialect: sqlite
-- Reads:  edges, pieces, channels, lined
-- A row:  one sample; place counts the samples of its channel up to it.
SELECT
  part.channel_id AS channel_id,
  reading.time AS time,
  reading.value AS value,
  reading.rowid - run.rows_before AS place
FROM edges AS part
JOIN (
  SELECT named.channel_id AS channel_id, MAX(piece.last_row) - named.readings AS rows_before
  FROM pieces AS piece
  JOIN channels AS named ON named.asset = piece.asset AND named.channel = piece.channel
  GROUP BY named.channel_id, named.readings
) AS run ON run.channel_id = part.channel_id
CROSS JOIN lined AS reading
  ON reading.rowid BETWEEN run.rows_before + part.samples_before + 1
  AND run.rows_before + part.samples_before + part.samples
WHERE part.is_edge = 1
