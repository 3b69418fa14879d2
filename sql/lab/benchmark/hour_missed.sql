-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Hour, missed: rows of the extract script that the state does not show.
SELECT
  (
    SELECT COUNT(*)
    FROM (
      FROM extract_bucket
      EXCEPT
      SELECT version_id, bucket_no, first_time, last_time, novel, out_of_range, novel_in_window
      FROM gam_state_visible_bucket
    ) AS buckets
  )
  + (
    SELECT COUNT(*)
    FROM (
      FROM extract_novel
      EXCEPT
      SELECT version_id, bucket_no, cell_key, visits, first_time, last_time
      FROM gam_state_visible_novel
    ) AS cells
  ) AS missed
