-- Inconsistent judgements: those that are not as they must be.
-- Reads:  judged_until, judged_again, kept_judgements
-- A row:  one version with such; since is the beginning of the first.
SELECT
  part.version_id AS version_id,
  CAST(COUNT(*) AS BIGINT) AS differing,
  MIN(matched.since) AS since
FROM (
  SELECT channel_id, judgement_no, MIN(odd.first_time) AS since
  FROM (
    SELECT channel_id, judgement_no, first_time
    FROM (
        SELECT
          made.channel_id AS channel_id,
          made.judgement_no AS judgement_no,
          made.bucket_no AS bucket_no,
          made.run_id AS run_id,
          made.first_time AS first_time,
          made.last_time AS last_time,
          made.novel AS novel,
          made.root AS root,
          made.reference AS reference,
          made.height AS height,
          made.evidence AS evidence,
          made.is_open AS is_open,
          made.last_zero AS last_zero,
          0 AS is_stored
        FROM judged_again AS made
        UNION ALL
        SELECT
          kept.channel_id AS channel_id,
          kept.judgement_no AS judgement_no,
          kept.bucket_no AS bucket_no,
          kept.run_id AS run_id,
          kept.first_time AS first_time,
          kept.last_time AS last_time,
          kept.novel AS novel,
          kept.root AS root,
          kept.reference AS reference,
          kept.height AS height,
          kept.evidence AS evidence,
          kept.is_open AS is_open,
          kept.last_zero AS last_zero,
          1 AS is_stored
        FROM kept_judgements AS kept
    ) AS both_sides
    GROUP BY
      channel_id,
      judgement_no,
      bucket_no,
      run_id,
      first_time,
      last_time,
      novel,
      root,
      reference,
      height,
      evidence,
      is_open,
      last_zero
    HAVING COUNT(*) <> 2 * SUM(is_stored)
  ) AS odd
  GROUP BY channel_id, judgement_no
) AS matched
JOIN judged_until AS part ON part.channel_id = matched.channel_id
GROUP BY part.version_id
