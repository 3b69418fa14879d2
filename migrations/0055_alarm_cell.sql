-- Alarm cell: the ten commonest novel cells of each episode of an active version, one interval per axis, each beside the
-- healthy cell that lies nearest: the one whose largest step on any axis is smallest, of several the one of the smallest
-- key.
CREATE OR REPLACE VIEW stored_alarm_cell AS
SELECT
  ranked.monitor AS monitor,
  ranked.episode_id AS episode_id,
  ranked.asset AS asset,
  ranked.channel AS channel,
  ranked.version_id AS version_id,
  ranked.cell_rank AS cell_rank,
  ranked.cell_key AS cell_key,
  ranked.visits AS visits,
  CASE WHEN ranked.is_dated = 1 THEN MAKE_TIMESTAMP(ranked.first_tick) END AS first_time,
  CASE WHEN ranked.is_dated = 1 THEN MAKE_TIMESTAMP(ranked.last_tick) END AS last_time,
  ranked.first_tick AS first_tick,
  ranked.last_tick AS last_tick,
  ranked.axis AS axis,
  ranked.samples_before AS samples_before,
  ranked.place AS place,
  ranked.value_from AS value_from,
  ranked.value_to AS value_to,
  ranked.nearest_key AS nearest_key,
  ranked.steps AS steps,
  ranked.displacement AS displacement
FROM (
  SELECT
    apart.monitor AS monitor,
    apart.episode_id AS episode_id,
    apart.asset AS asset,
    apart.channel AS channel,
    apart.version_id AS version_id,
    apart.cell_rank AS cell_rank,
    apart.cell_key AS cell_key,
    apart.visits AS visits,
    apart.is_dated AS is_dated,
    apart.first_tick AS first_tick,
    apart.last_tick AS last_tick,
    apart.axis AS axis,
    apart.samples_before AS samples_before,
    apart.place AS place,
    apart.value_from AS value_from,
    apart.value_to AS value_to,
    apart.nearest_key AS nearest_key,
    apart.steps AS steps,
    apart.displacement AS displacement,
    CAST(
      DENSE_RANK() OVER (
        PARTITION BY apart.version_id, apart.episode_id, apart.cell_key ORDER BY apart.steps, apart.nearest_key
      ) AS BIGINT
    ) AS nearness
  FROM (
    SELECT
      fresh.monitor AS monitor,
      fresh.episode_id AS episode_id,
      fresh.asset AS asset,
      fresh.channel AS channel,
      fresh.version_id AS version_id,
      fresh.cell_rank AS cell_rank,
      fresh.cell_key AS cell_key,
      fresh.visits AS visits,
      fresh.is_dated AS is_dated,
      fresh.first_tick AS first_tick,
      fresh.last_tick AS last_tick,
      fresh.axis AS axis,
      fresh.samples_before AS samples_before,
      fresh.place AS place,
      fresh.value_from AS value_from,
      fresh.value_to AS value_to,
      healthy.cell_key AS nearest_key,
      fresh.code - healthy.code AS displacement,
      MAX(CASE WHEN fresh.code > healthy.code THEN fresh.code - healthy.code ELSE healthy.code - fresh.code END) OVER (
        PARTITION BY fresh.version_id, fresh.episode_id, fresh.cell_key, healthy.cell_key
      ) AS steps
    FROM (
      SELECT
        placed.monitor AS monitor,
        common.episode_id AS episode_id,
        placed.asset AS asset,
        placed.channel AS channel,
        placed.version_id AS version_id,
        common.cell_rank AS cell_rank,
        placed.cell_key AS cell_key,
        common.visits AS visits,
        CASE WHEN placed.first_time IS NULL THEN 0 ELSE 1 END AS is_dated,
        common.first_tick AS first_tick,
        common.last_tick AS last_tick,
        placed.axis AS axis,
        placed.samples_before AS samples_before,
        placed.place AS place,
        placed.value_from AS value_from,
        placed.value_to AS value_to,
        placed.code AS code
      FROM stored_cell AS placed
      JOIN (
        SELECT
          seen.version_id AS version_id,
          seen.episode_id AS episode_id,
          seen.cell_key AS cell_key,
          seen.visits AS visits,
          seen.first_tick AS first_tick,
          seen.last_tick AS last_tick,
          CAST(
            ROW_NUMBER() OVER (
              PARTITION BY seen.version_id, seen.episode_id ORDER BY seen.visits DESC, seen.cell_key
            ) AS BIGINT
          ) AS cell_rank
        FROM (
          SELECT
            raised.version_id AS version_id,
            raised.episode_id AS episode_id,
            strange.cell_key AS cell_key,
            CAST(SUM(strange.visits) AS BIGINT) AS visits,
            MIN(strange.first_time) AS first_tick,
            MAX(strange.last_time) AS last_tick
          FROM stored_visible_episode AS raised
          JOIN stored_version AS made ON made.version_id = raised.version_id
          JOIN stored_visible_novel AS strange
            ON strange.version_id = raised.version_id
            AND strange.bucket_no * made.stride >= raised.first_judgement * made.window_length
            AND strange.bucket_no * made.stride < (raised.last_judgement + 1) * made.window_length
          WHERE raised.status <> 'merged' AND raised.status <> 'withdrawn'
          GROUP BY raised.version_id, raised.episode_id, strange.cell_key
        ) AS seen
      ) AS common ON common.version_id = placed.version_id AND common.cell_key = placed.cell_key
      WHERE placed.kind = 'novel' AND common.cell_rank <= 10
    ) AS fresh
    JOIN stored_cell AS healthy ON healthy.version_id = fresh.version_id AND healthy.axis = fresh.axis
    WHERE healthy.kind = 'healthy'
  ) AS apart
) AS ranked
WHERE ranked.nearness = 1;

COMMENT ON VIEW stored_alarm_cell
  IS 'Where an episode went instead: its ten commonest novel cells; one row per cell and axis';
COMMENT ON COLUMN stored_alarm_cell.monitor IS 'The monitor';
COMMENT ON COLUMN stored_alarm_cell.episode_id IS 'Number of the episode';
COMMENT ON COLUMN stored_alarm_cell.asset IS 'The machine';
COMMENT ON COLUMN stored_alarm_cell.channel IS 'The signal';
COMMENT ON COLUMN stored_alarm_cell.version_id IS 'The version whose judgements it is made of; an active one';
COMMENT ON COLUMN stored_alarm_cell.cell_rank IS '1 for the commonest novel cell of the episode, up to 10';
COMMENT ON COLUMN stored_alarm_cell.cell_key IS 'The cell: its codes on the m axes, as one integer';
COMMENT ON COLUMN stored_alarm_cell.visits IS 'Vectors of the episode in it';
COMMENT ON COLUMN stored_alarm_cell.first_time
  IS 'Time of the first of them (UTC); NULL where the source counts time, see first_tick';
COMMENT ON COLUMN stored_alarm_cell.last_time
  IS 'Time of the last of them (UTC); NULL where the source counts time, see last_tick';
COMMENT ON COLUMN stored_alarm_cell.first_tick
  IS 'Time of the first of them: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_alarm_cell.last_tick
  IS 'Time of the last of them: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_alarm_cell.axis IS 'Which coordinate: 0 is the newest sample of the vector';
COMMENT ON COLUMN stored_alarm_cell.samples_before IS 'How many samples before the newest it lies: axis * tau';
COMMENT ON COLUMN stored_alarm_cell.place
  IS 'below or above the range of calibration; within: in the bin from value_from to value_to';
COMMENT ON COLUMN stored_alarm_cell.value_from IS 'Lower end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_alarm_cell.value_to IS 'Upper end in units of the signal; NULL where there is none';
COMMENT ON COLUMN stored_alarm_cell.nearest_key IS 'The healthy cell that lies nearest';
COMMENT ON COLUMN stored_alarm_cell.steps IS 'How far that is: the largest step on any axis, in bins';
COMMENT ON COLUMN stored_alarm_cell.displacement IS 'By how many bins it lies above that on this axis; less than 0 for below';
