-- Ambiguous: where states repeat exactly, ten times on average with all coordinates, those whose next coordinate
-- is not told by the ones they have: with it there are more than 1 % more states. False neighbours cannot tell:
-- an exact repetition is at distance zero and skipped, and a cycle of whole samples has no others near enough.
-- Reads:  states
-- A row:  one dimension of one channel that is too small; 0 is none.
SELECT channel_id, larger_m - 1 AS m
FROM (
  SELECT
    channel_id,
    m AS larger_m,
    states,
    LAG(states, 1) OVER (PARTITION BY channel_id ORDER BY m) AS states_before,
    MAX(states) OVER (PARTITION BY channel_id) AS most_states,
    MIN(vectors) OVER (PARTITION BY channel_id) AS fewest_vectors
  FROM states
) AS counted
WHERE 10 * most_states <= fewest_vectors
  AND 100 * states > 101 * states_before
