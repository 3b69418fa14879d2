-- Read sums: what was read of each channel, as far as rows may still come late, in one integer; twice as far, so that
-- it shows where one came too late. A run answers for what it has scored, and not for the samples before that: a row that
-- came among them just before they were read is missing in what is stored, and in the sum of the run that wrote that.
-- Reads:  identified, cohort, seen
-- A row:  one channel that has a row in its range.
-- Slots:  :code  the expression of support/code.sql
--         :mixed the expression of stored/scoring/read_mixed.sql, or 0 where rows are only counted
--         :mark  what one reading adds: the expression of stored/scoring/read_mark.sql
SELECT
  channel_id,
  MIN(reads.summed_from) AS summed_from,
  CAST(SUM(:mark) AS BIGINT) AS read_sum
FROM (
  SELECT channel_id, summed_from, :mixed AS mixed
  FROM (
    SELECT channel_id, summed_from, time, :code AS code
    FROM (
      SELECT
        late.channel_id AS channel_id,
        late.summed_from AS summed_from,
        reading.time AS time,
        reading.value AS value,
        late.lo AS lo,
        late.hi AS hi
      FROM identified AS reading
      JOIN (
        SELECT
          member.channel_id AS channel_id,
          ranged.read_to AS read_to,
          member.lo AS lo,
          member.hi AS hi,
          CASE
            WHEN ranged.read_to - 2 * member.late_by > member.read_from
              AND ranged.read_to - 2 * member.late_by > member.first_scored
              THEN ranged.read_to - 2 * member.late_by
            WHEN member.first_bucket > 0 THEN member.first_scored
            ELSE member.read_from
          END AS summed_from
        FROM cohort AS member
        JOIN seen AS ranged ON ranged.channel_id = member.channel_id
      ) AS late ON late.channel_id = reading.channel_id
      WHERE reading.time BETWEEN late.summed_from AND late.read_to
    ) AS ranged_readings
  ) AS coded
) AS reads
GROUP BY channel_id
