-- Moving codes in stored order: as embedding/moving_codes.sql, where a sample that stands still counts as missing. For
-- DuckDB, which carries the newest sample that moved along the rows as they are stored. Proof: that of the vectors
-- (streams/vectors.sql).
-- Reads:  codes
-- A row:  one sample; still = 1 where it stands still.
-- Slots:  :still_after  samples
--         :begins       whether a segment begins with the sample
--         :carried      columns that travel with it
SELECT
  time,
  CASE WHEN position - unmoved_from >= :still_after - 1 THEN 0 ELSE marked_code END AS code,
  CASE WHEN position - unmoved_from >= :still_after - 1 THEN 1 ELSE 0 END AS still,
  :carried
FROM (
  SELECT
    time,
    marked_code,
    :carried,
    position,
    MAX(CASE WHEN moving = 1 THEN position END) OVER (
      ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS unmoved_from
  FROM (
    SELECT
      time,
      code AS marked_code,
      :carried,
      CAST(ROW_NUMBER() OVER () AS BIGINT) AS position,
      CASE WHEN :begins THEN 1 WHEN value = LAG(value, 1) OVER () THEN 0 ELSE 1 END AS moving
    FROM codes
  ) AS compared
) AS held
