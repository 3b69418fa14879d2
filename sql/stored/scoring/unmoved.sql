-- Unmoved: how many of its ranges add up to what they did when they were read, so that in them nothing came late, went
-- or changed. CROSS JOIN keeps SQLite to this order: it would else read the whole source once for each channel.
-- Reads:  identified, ranges
-- A row:  one channel of which a range does.
-- Slots:  :code  the expression of support/code.sql, of bins that a range has as a column
--         :mixed, :mark  what one reading adds; see stored/scoring/read_sums.sql
SELECT channel_id, CAST(COUNT(*) AS BIGINT) AS alike
FROM (
  SELECT
    ranged.channel_id AS channel_id,
    ranged.run_id AS run_id,
    ranged.read_sum AS sum_then,
    CAST(SUM(:mark) AS BIGINT) AS sum_now
  FROM ranges AS ranged
  JOIN (
    SELECT channel_id, time, :mixed AS mixed
    FROM (
      SELECT channel_id, time, :code AS code
      FROM (
        SELECT
          reading.channel_id AS channel_id,
          reading.time AS time,
          reading.value AS value,
          scale.lo AS lo,
          scale.hi AS hi,
          scale.bins AS bins
        FROM identified AS reading
        CROSS JOIN (
          SELECT channel_id, MIN(asked.lo) AS lo, MIN(asked.hi) AS hi, MIN(asked.bins) AS bins
          FROM ranges AS asked
          GROUP BY channel_id
        ) AS scale
        WHERE scale.channel_id = reading.channel_id
      ) AS read_again
    ) AS coded
  ) AS reads
    ON reads.channel_id = ranged.channel_id AND reads.time BETWEEN ranged.summed_from AND ranged.read_to
  GROUP BY ranged.channel_id, ranged.run_id, ranged.read_sum
) AS summed
WHERE sum_now = sum_then
GROUP BY channel_id
