-- Numbered: the scored vectors of a channel in order, from 1, with the novel ones counted on.
-- Reads:  novelty
-- A row:  one scored vector.
-- Slots:  :carried  columns that travel with the vector
SELECT
  channel_id,
  time,
  cell_key,
  out_of_range,
  straddling,
  position,
  context_time,
  novel,
  CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) AS number,
  CAST(
    SUM(CASE WHEN novel = 1 THEN 1 ELSE 0 END) OVER (
      PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS BIGINT
  ) AS novel_so_far,
  :carried
FROM novelty
