-- Inconsistent bands: first judgements of episodes whose bands are not all of their vectors, or of their novel ones.
-- Where the source no longer held what was scored there are no visits. A row that is there twice says the same.
-- Reads:  stored_band_visit, stored_visible_judgement, stored_version, stored_channel
-- A row:  one version with such.
-- Slots:  :monitor_id
SELECT
  band_sums.version_id AS version_id,
  CAST(COUNT(*) AS BIGINT) AS differing
FROM (
  SELECT
    version_id,
    judgement_no,
    run_id,
    CAST(SUM(band_visit.visits) AS BIGINT) AS visits,
    CAST(SUM(band_visit.novel) AS BIGINT) AS novel
  FROM (
    SELECT DISTINCT version_id, judgement_no, run_id, band, visits, novel
    FROM stored_band_visit
  ) AS band_visit
  GROUP BY version_id, judgement_no, run_id
) AS band_sums
JOIN stored_visible_judgement AS judged
  ON judged.version_id = band_sums.version_id
  AND judged.judgement_no = band_sums.judgement_no
  AND judged.run_id = band_sums.run_id
JOIN stored_version AS version ON version.version_id = band_sums.version_id
JOIN stored_channel AS channel_row ON channel_row.channel_id = version.channel_id
WHERE channel_row.monitor_id = :monitor_id
  AND (band_sums.visits <> 0 OR band_sums.novel <> 0)
  AND (band_sums.visits <> version.window_length OR band_sums.novel <> judged.novel)
GROUP BY band_sums.version_id
