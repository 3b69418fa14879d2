-- Alarm figures: how much of what an episode visited is new, since its onset: by judgement, out of range, and in states.
-- Later states are those first visited in the later half. What was pruned is not known: NULL.
-- Reads:  stored_alarm, stored_version, stored_visible_judgement, stored_visible_bucket, stored_visible_novel
-- A row:  one episode that is neither merged nor withdrawn, of which judgements are kept.
-- Slots:  :monitor  its name
SELECT
  raised.episode_id AS episode,
  version.window_length AS window_length,
  CASE WHEN judged.judgements = judged.expected THEN judged.judgements END AS judgements,
  CASE WHEN judged.judgements = judged.expected THEN judged.novel END AS novel,
  CASE WHEN judged.judgements = judged.expected THEN judged.onset_novel END AS onset_novel,
  CASE WHEN judged.judgements = judged.expected THEN judged.early_novel END AS early_novel,
  CASE WHEN judged.judgements = judged.expected THEN judged.highest_novel END AS highest_novel,
  CASE
    WHEN bucketed.hit = 1 AND bucketed.novel = judged.novel AND judged.judgements = judged.expected
      THEN bucketed.out_of_range
  END AS out_of_range,
  CASE
    WHEN visited.hit = 1 AND visited.novel = judged.novel AND judged.judgements = judged.expected
      THEN visited.states
  END AS states,
  CASE
    WHEN visited.hit = 1 AND visited.novel = judged.novel AND judged.judgements = judged.expected
      THEN visited.later_states
  END AS later_states
FROM stored_alarm AS raised
JOIN stored_version AS version ON version.version_id = raised.version_id
JOIN (
  SELECT
    of_episode.episode_id AS episode_id,
    CAST(COUNT(*) AS BIGINT) AS judgements,
    CAST(SUM(part.novel) AS BIGINT) AS novel,
    MAX(CASE WHEN part.judgement_no = of_episode.onset THEN part.novel END) AS onset_novel,
    MAX(CASE WHEN part.judgement_no <= of_episode.onset + 1 THEN part.novel END) AS early_novel,
    MAX(part.novel) AS highest_novel,
    MAX(of_episode.last_judgement - of_episode.onset + 1) AS expected
  FROM stored_alarm AS of_episode
  JOIN stored_visible_judgement AS part
    ON part.version_id = of_episode.version_id
    AND part.judgement_no >= of_episode.onset
    AND part.judgement_no <= of_episode.last_judgement
  WHERE of_episode.monitor = :monitor
  GROUP BY of_episode.episode_id
) AS judged ON judged.episode_id = raised.episode_id
LEFT JOIN (
  SELECT
    of_episode.episode_id AS episode_id,
    CAST(SUM(bucket.novel) AS BIGINT) AS novel,
    CAST(SUM(bucket.out_of_range) AS BIGINT) AS out_of_range,
    1 AS hit
  FROM stored_alarm AS of_episode
  JOIN stored_version AS scale ON scale.version_id = of_episode.version_id
  JOIN stored_visible_bucket AS bucket
    ON bucket.version_id = of_episode.version_id
    AND bucket.bucket_no * scale.stride >= of_episode.onset * scale.window_length
    AND bucket.bucket_no * scale.stride < (of_episode.last_judgement + 1) * scale.window_length
  WHERE of_episode.monitor = :monitor
  GROUP BY of_episode.episode_id
) AS bucketed ON bucketed.episode_id = raised.episode_id
LEFT JOIN (
  SELECT
    met.episode_id AS episode_id,
    CAST(SUM(met.visits) AS BIGINT) AS novel,
    CAST(COUNT(*) AS BIGINT) AS states,
    CAST(SUM(CASE WHEN met.first_vector >= met.middle THEN 1 ELSE 0 END) AS BIGINT) AS later_states,
    1 AS hit
  FROM (
    SELECT
      of_episode.episode_id AS episode_id,
      cell.cell_key AS cell_key,
      CAST(SUM(cell.visits) AS BIGINT) AS visits,
      MIN(2 * cell.bucket_no * scale.stride) AS first_vector,
      MIN((of_episode.onset + of_episode.last_judgement + 1) * scale.window_length) AS middle
    FROM stored_alarm AS of_episode
    JOIN stored_version AS scale ON scale.version_id = of_episode.version_id
    JOIN stored_visible_novel AS cell
      ON cell.version_id = of_episode.version_id
      AND cell.bucket_no * scale.stride >= of_episode.onset * scale.window_length
      AND cell.bucket_no * scale.stride < (of_episode.last_judgement + 1) * scale.window_length
    WHERE of_episode.monitor = :monitor
    GROUP BY of_episode.episode_id, cell.cell_key
  ) AS met
  GROUP BY met.episode_id
) AS visited ON visited.episode_id = raised.episode_id
WHERE raised.monitor = :monitor AND raised.status <> 'merged' AND raised.status <> 'withdrawn'
ORDER BY raised.episode_id
