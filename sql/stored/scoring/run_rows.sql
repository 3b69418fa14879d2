-- Run rows: what commits a run, one row per version; appended last of all.
-- Reads:  cohort, changed, new_counts, seen, recount, settled, stillness, stamp
-- A row:  one version of which something new was read, something differs, calibration was counted anew, or no run has
--         looked at it yet; else there is nothing to record. (Who is looked at once a day is counted anew then.) One
--         without any row in its range, not even its context, hides nothing: from_bucket is beyond all buckets, and
--         what was settled is what an earlier run says. Where
--         no new bucket is settled, it is the one that stayed, after which this run began. hides = 0 where no row of an
--         earlier run is left that it hides: it deletes them in the same commit, or there can be none.
SELECT
  stamp.run_id AS run_id,
  member.version_id AS version_id,
  CASE WHEN ranged.hit = 1 THEN part.first_bucket ELSE 4611686018427387904 END AS from_bucket,
  member.read_from AS read_from,
  CASE WHEN ranged.hit = 1 THEN ranged.read_to END AS read_to,
  CASE WHEN ranged.hit = 1 THEN ranged.rows_read ELSE 0 END AS rows_read,
  CASE WHEN ranged.hit = 1 THEN ranged.context_rows ELSE 0 END AS context_rows,
  member.context_expected AS context_expected,
  CASE
    WHEN member.recounted = 1 THEN CASE WHEN again.hit = 1 THEN again.calibration_readings ELSE 0 END
  END AS calibration_readings,
  member.lookback AS lookback,
  CASE
    WHEN ranged.hit = 1
      THEN CASE WHEN done.hit = 1 THEN done.settled_bucket ELSE member.first_bucket - 1 END
  END AS settled_bucket,
  CASE
    WHEN ranged.hit = 1
      THEN CASE
        WHEN done.hit = 1 THEN done.settled_time
        WHEN member.first_bucket > 0 THEN member.first_scored - 1
      END
  END AS settled_time,
  CASE
    WHEN ranged.hit = 1
      THEN CASE
        WHEN done.hit = 1 THEN done.settled_context
        WHEN member.first_bucket > 0 THEN member.read_from
      END
  END AS settled_context,
  stamp.started AS started,
  stamp.committed AS committed,
  member.planned_from AS planned_from,
  CASE WHEN calm.hit = 1 THEN calm.still_since END AS still_since,
  CASE WHEN CASE WHEN ranged.hit = 1 THEN stamp.deletes_hidden ELSE 1 END = 1 THEN CAST(0 AS BIGINT) END AS hides,
  CASE WHEN ranged.hit = 1 THEN member.first_bucket END AS made_from,
  stamp.episodes_pending AS episodes_pending
FROM cohort AS member
JOIN changed AS part ON part.channel_id = member.channel_id
CROSS JOIN stamp
LEFT JOIN (
  SELECT channel_id, read_to, rows_read, context_rows, 1 AS hit
  FROM seen
) AS ranged ON ranged.channel_id = member.channel_id
LEFT JOIN (
  SELECT channel_id, calibration_readings, 1 AS hit
  FROM recount
) AS again ON again.channel_id = member.channel_id
LEFT JOIN (
  SELECT version_id, settled_bucket, settled_time, settled_context, 1 AS hit
  FROM settled
) AS done ON done.version_id = member.version_id
LEFT JOIN (
  SELECT channel_id, still_since, 1 AS hit
  FROM stillness
) AS calm ON calm.channel_id = member.channel_id
LEFT JOIN (
  SELECT channel_id, 1 AS hit
  FROM new_counts
) AS fresh ON fresh.channel_id = member.channel_id
WHERE member.recounted = 1
  OR member.planned_from = 0
  OR part.differs = 1
  OR fresh.hit = 1
  OR (ranged.hit = 1 AND (ranged.read_to <> member.last_read OR ranged.context_rows <> member.context_expected))
