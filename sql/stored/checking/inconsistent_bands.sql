-- Inconsistent bands: first judgements of episodes whose bands are not all of their vectors, or of their novel ones.
-- Where the source no longer held what was scored there are no visits. A row that is there twice says the same.
-- Reads:  stored_band_visit, stored_visible_judgement, stored_version, stored_channel
-- A row:  one version with such.
-- Slots:  :monitor_id
SELECT
  placed.version_id AS version_id,
  CAST(COUNT(*) AS BIGINT) AS differing
FROM (
  SELECT
    version_id,
    judgement_no,
    run_id,
    CAST(SUM(told.visits) AS BIGINT) AS visits,
    CAST(SUM(told.novel) AS BIGINT) AS novel
  FROM (
    SELECT DISTINCT version_id, judgement_no, run_id, band, visits, novel
    FROM stored_band_visit
  ) AS told
  GROUP BY version_id, judgement_no, run_id
) AS placed
JOIN stored_visible_judgement AS judged
  ON judged.version_id = placed.version_id
  AND judged.judgement_no = placed.judgement_no
  AND judged.run_id = placed.run_id
JOIN stored_version AS made ON made.version_id = placed.version_id
JOIN stored_channel AS known ON known.channel_id = made.channel_id
WHERE known.monitor_id = :monitor_id
  AND (placed.visits <> 0 OR placed.novel <> 0)
  AND (placed.visits <> made.window_length OR placed.novel <> judged.novel)
GROUP BY placed.version_id
