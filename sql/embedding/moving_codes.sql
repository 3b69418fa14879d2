-- Moving codes: codes, where a sample that stands still counts as missing (alarms, section 1): it and the
-- still_after - 1 before it in its segment are all equal, and none of them is missing. It looks back only.
-- Reads:  codes
-- A row:  one sample; still = 1 where it stands still.
-- Slots:  :still_after  samples
--         :begins       whether a segment begins with the sample
--         :carried      columns that travel with it
SELECT
  channel_id,
  time,
  CASE WHEN position - unmoved_from >= :still_after - 1 THEN 0 ELSE marked_code END AS code,
  CASE WHEN position - unmoved_from >= :still_after - 1 THEN 1 ELSE 0 END AS still,
  :carried
FROM (
  SELECT
    channel_id,
    time,
    marked_code,
    :carried,
    position,
    MAX(CASE WHEN moving = 1 THEN position END) OVER (
      PARTITION BY channel_id ORDER BY time ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS unmoved_from
  FROM (
    SELECT
      channel_id,
      time,
      code AS marked_code,
      :carried,
      CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) AS position,
      CASE
        WHEN :begins THEN 1
        WHEN value = LAG(value, 1) OVER (PARTITION BY channel_id ORDER BY time) THEN 0
        ELSE 1
      END AS moving
    FROM codes
  ) AS compared
) AS held
