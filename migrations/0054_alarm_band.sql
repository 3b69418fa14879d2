-- Alarm band: in which part of the range an episode stands out: the novel vectors of its first five judgements, less those
-- that as many vectors there held in calibration. A band begins and ends at edges of bins, which calibration saw.
CREATE OR REPLACE VIEW stored_alarm_band AS
SELECT
  watching.name AS monitor,
  told.episode_id AS episode_id,
  named.asset AS asset,
  named.channel AS channel,
  told.version_id AS version_id,
  told.band AS band,
  CASE
    WHEN told.band < 0 THEN 'below'
    WHEN told.band = told.bands THEN 'above'
    ELSE 'within'
  END AS place,
  CASE
    WHEN told.band < 0 THEN NULL
    WHEN told.band = told.bands THEN learnt.calibrated_hi
    ELSE learnt.calibrated_lo
      + (learnt.calibrated_hi - learnt.calibrated_lo)
        * FLOOR((CAST(told.band * told.bins + told.bands AS DOUBLE) - CAST(5e-1 AS DOUBLE)) / CAST(told.bands AS DOUBLE))
        / CAST(told.bins AS DOUBLE)
  END AS value_from,
  CASE
    WHEN told.band = told.bands THEN NULL
    WHEN told.band < 0 THEN learnt.calibrated_lo
    WHEN told.band = told.bands - 1 THEN learnt.calibrated_hi
    ELSE learnt.calibrated_lo
      + (learnt.calibrated_hi - learnt.calibrated_lo)
        * FLOOR(
          (CAST((told.band + 1) * told.bins + told.bands AS DOUBLE) - CAST(5e-1 AS DOUBLE)) / CAST(told.bands AS DOUBLE)
        )
        / CAST(told.bins AS DOUBLE)
  END AS value_to,
  told.novel AS novel,
  told.visits AS visits,
  CASE WHEN taught.hit = 1 THEN taught.novel_buffered ELSE 0 END AS calibration_novel,
  CASE WHEN taught.hit = 1 THEN taught.visits ELSE 0 END AS calibration_visits,
  CASE
    WHEN taught.hit = 1
      THEN CAST(told.novel * taught.visits - told.visits * taught.novel_buffered AS DOUBLE)
        / CAST(CASE WHEN taught.visits > 0 THEN taught.visits ELSE 1 END AS DOUBLE)
    ELSE CAST(told.novel AS DOUBLE)
  END AS excess
FROM (
  SELECT
    raised.monitor_id AS monitor_id,
    raised.episode_id AS episode_id,
    raised.channel_id AS channel_id,
    raised.version_id AS version_id,
    made.support_id AS support_id,
    made.bins AS bins,
    CASE WHEN made.bins < 20 THEN made.bins ELSE 20 END AS bands,
    counted.band AS band,
    CAST(SUM(counted.novel) AS BIGINT) AS novel,
    CAST(SUM(counted.visits) AS BIGINT) AS visits
  FROM stored_visible_episode AS raised
  JOIN stored_version AS made ON made.version_id = raised.version_id
  JOIN (
    SELECT
      known.version_id AS version_id,
      known.judgement_no AS judgement_no,
      known.band AS band,
      MAX(known.novel) AS novel,
      MAX(known.visits) AS visits
    FROM stored_band_visit AS known
    JOIN stored_visible_judgement AS said
      ON said.version_id = known.version_id
      AND said.judgement_no = known.judgement_no
      AND said.run_id = known.run_id
    WHERE known.visits > 0
    GROUP BY known.version_id, known.judgement_no, known.band
  ) AS counted
    ON counted.version_id = raised.version_id
    AND counted.judgement_no >= raised.first_judgement
    AND counted.judgement_no <= raised.last_judgement
    AND counted.judgement_no < raised.first_judgement + 5
  WHERE raised.status <> 'merged' AND raised.status <> 'withdrawn'
  GROUP BY
    raised.monitor_id,
    raised.episode_id,
    raised.channel_id,
    raised.version_id,
    made.support_id,
    made.bins,
    counted.band
) AS told
JOIN stored_channel AS named ON named.channel_id = told.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = told.monitor_id
JOIN stored_bounds AS learnt ON learnt.support_id = told.support_id
LEFT JOIN (
  SELECT
    part.version_id AS version_id,
    part.band AS band,
    part.visits AS visits,
    part.novel_buffered AS novel_buffered,
    1 AS hit
  FROM stored_band AS part
  JOIN (
    SELECT
      own.version_id AS version_id,
      own.g AS g,
      CAST(ROW_NUMBER() OVER (PARTITION BY own.version_id ORDER BY own.limit_no DESC) AS BIGINT) AS limits_back
    FROM stored_limit AS own
    WHERE own.reason IS NULL
  ) AS limited ON limited.version_id = part.version_id AND limited.g = part.g
  WHERE limited.limits_back = 1
) AS taught ON taught.version_id = told.version_id AND taught.band = told.band;

COMMENT ON VIEW stored_alarm_band
  IS 'In which part of its range an episode stands out; one row per band that its first five judgements visited';
COMMENT ON COLUMN stored_alarm_band.monitor IS 'The monitor';
COMMENT ON COLUMN stored_alarm_band.episode_id IS 'Number of the episode';
COMMENT ON COLUMN stored_alarm_band.asset IS 'The machine';
COMMENT ON COLUMN stored_alarm_band.channel IS 'The signal';
COMMENT ON COLUMN stored_alarm_band.version_id IS 'The version whose judgements it is made of';
COMMENT ON COLUMN stored_alarm_band.band
  IS '-1 below the range of calibration, 0, 1, ... in it from low to high, 20 (or bins, if they are fewer) above it';
COMMENT ON COLUMN stored_alarm_band.place
  IS 'below or above the range of calibration, or within: from value_from to value_to';
COMMENT ON COLUMN stored_alarm_band.value_from IS 'Lower end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_alarm_band.value_to IS 'Upper end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_alarm_band.novel IS 'Novel vectors of the first five judgements whose newest sample lies there';
COMMENT ON COLUMN stored_alarm_band.visits IS 'All their vectors whose newest sample lies there';
COMMENT ON COLUMN stored_alarm_band.calibration_novel
  IS 'Vectors of calibration there whose cell no block farther away visited';
COMMENT ON COLUMN stored_alarm_band.calibration_visits IS 'All vectors of calibration there';
COMMENT ON COLUMN stored_alarm_band.excess
  IS 'novel less visits * calibration_novel / calibration_visits: the novel vectors that calibration does not explain';
