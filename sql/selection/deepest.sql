-- Deepest: the last vector that the largest dimension draws. Of the vectors that can be followed further
-- there are fewer, so that no smaller dimension draws one that comes later.
-- Reads:  scattered
-- A row:  one channel that has vectors to be followed furthest.
-- Slots:  :last        the largest dimension
--         :references  how many are drawn
SELECT channel_id, MAX(ordered.scattered) AS last_drawn, CAST(COUNT(*) AS BIGINT) AS drawn
FROM (
  SELECT
    channel_id,
    scattered,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY scattered, place) AS BIGINT
    ) AS turn
  FROM scattered
  WHERE depth > :last
) AS ordered
WHERE turn <= :references
GROUP BY channel_id
