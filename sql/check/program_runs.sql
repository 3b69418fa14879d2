-- Program runs: stretches in which a machine runs one program. Readings that name none are left out.
-- Reads:  samples
-- A row:  one run of one channel.
SELECT channel_id, program, run_no, CAST(COUNT(*) AS BIGINT) AS readings
FROM (
  SELECT
    channel_id,
    program,
    CAST(
      SUM(changed) OVER (
        PARTITION BY channel_id ORDER BY time, program ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS run_no
  FROM (
    SELECT
      channel_id,
      time,
      program,
      CASE
        WHEN program = LAG(program, 1) OVER (PARTITION BY channel_id ORDER BY time, program) THEN 0
        ELSE 1
      END AS changed
    FROM samples
    WHERE program IS NOT NULL
  ) AS followed_by
) AS counted
GROUP BY channel_id, program, run_no
