-- Jumps: counters that went on by far more at once than they usually do. No clock tells whether that is right.
-- Buckets end after as many vectors each, so the usual step follows from all steps from end to end but the largest.
-- Reads:  bucket_ends, the ends of successive buckets of a channel, and its newest row as the last of them
-- A row:  one channel that has jumped: by how much, and to what.
-- Slots:  :jump  usual steps that no counter goes on by at once
SELECT asset, channel, jump, jumped_to
FROM (
  SELECT
    stepping.asset AS asset,
    stepping.channel AS channel,
    MIN(stepping.stride) AS stride,
    MIN(stepping.largest) AS jump,
    MAX(CASE WHEN stepping.step = stepping.largest THEN stepping.end_time END) AS jumped_to,
    CAST(SUM(stepping.step) AS BIGINT) - MIN(stepping.largest) AS other_steps,
    CAST(COUNT(stepping.step) AS BIGINT) - 1 AS others
  FROM (
    SELECT
      asset,
      channel,
      stride,
      end_time,
      step,
      MAX(step) OVER (PARTITION BY asset, channel) AS largest
    FROM (
      SELECT
        asset,
        channel,
        stride,
        end_time,
        end_time - LAG(end_time, 1) OVER (PARTITION BY asset, channel ORDER BY end_time) AS step
      FROM bucket_ends
    ) AS ended
  ) AS stepping
  GROUP BY stepping.asset, stepping.channel
) AS stepped
WHERE others >= 2
  AND CAST(jump AS DOUBLE) * CAST(others AS DOUBLE) * CAST(stride AS DOUBLE)
    > CAST(:jump + stride AS DOUBLE) * CAST(other_steps AS DOUBLE)
