-- Stillness: which samples of a channel stand still at the beginning and at the end of what is read.
-- Reads:  moving_codes, cohort
-- A row:  one channel; context_still counts those before the first vector to be scored; still_since is the time of
--         the first of the others that last to the newest sample, NULL where that one does not stand still.
-- Slots:  :long_ago  an instant before all others
SELECT
  movement.channel_id AS channel_id,
  CAST(SUM(CASE WHEN movement.time < member.first_scored THEN movement.still ELSE 0 END) AS BIGINT) AS context_still,
  MIN(
    CASE WHEN movement.time > movement.last_moving AND movement.time >= member.first_scored THEN movement.time END
  ) AS still_since
FROM (
  SELECT
    channel_id,
    time,
    still,
    MAX(CASE WHEN still = 0 THEN time ELSE CAST(:long_ago AS BIGINT) END) OVER (PARTITION BY channel_id)
      AS last_moving
  FROM moving_codes
) AS movement
JOIN cohort AS member ON member.channel_id = movement.channel_id
GROUP BY movement.channel_id
