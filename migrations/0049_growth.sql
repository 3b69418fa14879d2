-- Growth: how many cells are known of each channel by then, one row per block of calibration and one per full
-- bucket, under the active version: cells of the support, and new ones. Of new ones only those that are kept count.
CREATE OR REPLACE VIEW stored_growth AS
SELECT
  watching.name AS monitor,
  named.asset AS asset,
  named.channel AS channel,
  version.version_no AS version_no,
  known.phase AS phase,
  known.number AS number,
  CASE WHEN watching.time_kind <> 'counter' THEN MAKE_TIMESTAMP(known.last_tick) END AS last_time,
  known.last_tick AS last_tick,
  known.healthy AS healthy,
  known.novel AS novel
FROM (
  SELECT
    made.version_id AS version_id,
    'calibration' AS phase,
    part.block AS number,
    part.last_time AS last_tick,
    CAST(SUM(CASE WHEN cell.first_time <= part.last_time THEN 1 ELSE 0 END) AS BIGINT) AS healthy,
    CAST(0 AS BIGINT) AS novel
  FROM stored_version AS made
  JOIN stored_block AS part ON part.support_id = made.support_id AND part.channel_id = made.channel_id
  JOIN stored_support AS cell ON cell.support_id = made.support_id
  GROUP BY made.version_id, part.block, part.last_time
  UNION ALL
  SELECT
    full_bucket.version_id AS version_id,
    'scored' AS phase,
    full_bucket.bucket_no AS number,
    full_bucket.last_time AS last_tick,
    learnt.cells AS healthy,
    CAST(
      SUM(CASE WHEN found.hit = 1 THEN found.cells ELSE 0 END) OVER (
        PARTITION BY full_bucket.version_id
        ORDER BY full_bucket.bucket_no
        ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS novel
  FROM stored_visible_bucket AS full_bucket
  JOIN stored_version AS made ON made.version_id = full_bucket.version_id
  JOIN stored_bounds AS learnt ON learnt.support_id = made.support_id
  LEFT JOIN (
    SELECT version_id, first_no, CAST(COUNT(*) AS BIGINT) AS cells, 1 AS hit
    FROM (
      SELECT version_id, cell_key, MIN(bucket_no) AS first_no
      FROM stored_visible_novel
      GROUP BY version_id, cell_key
    ) AS seen
    GROUP BY version_id, first_no
  ) AS found ON found.version_id = full_bucket.version_id AND found.first_no = full_bucket.bucket_no
) AS known
JOIN stored_version AS version ON version.version_id = known.version_id
JOIN (
  SELECT channel_id, MAX(version_id) AS newest_id
  FROM stored_version
  GROUP BY channel_id
) AS active ON active.newest_id = version.version_id
JOIN stored_channel AS named ON named.channel_id = version.channel_id
JOIN stored_monitor AS watching ON watching.monitor_id = named.monitor_id;

COMMENT ON VIEW stored_growth
  IS 'Cells known of each channel by then, active versions only; one row per block of calibration and per bucket';
COMMENT ON COLUMN stored_growth.monitor IS 'The monitor';
COMMENT ON COLUMN stored_growth.asset IS 'The machine';
COMMENT ON COLUMN stored_growth.channel IS 'The signal';
COMMENT ON COLUMN stored_growth.version_no IS 'Which calibration of the channel: 1, 2, ...';
COMMENT ON COLUMN stored_growth.phase IS 'calibration: a block of it; scored: a full bucket';
COMMENT ON COLUMN stored_growth.number IS 'Number of the block or of the bucket';
COMMENT ON COLUMN stored_growth.last_time
  IS 'Time of its last vector (UTC); NULL where the source counts time, see last_tick';
COMMENT ON COLUMN stored_growth.last_tick
  IS 'Time of its last vector: microseconds since 1970 (UTC), or the counter of the source';
COMMENT ON COLUMN stored_growth.healthy IS 'Cells of the support that were visited by then';
COMMENT ON COLUMN stored_growth.novel IS 'Different cells outside the support that were visited by then, of those kept';
