-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Written novel cells: one program's result, in a form that can be compared.
SELECT
  CAST(channel_id AS BIGINT) AS channel_id,
  CAST(bucket_no AS BIGINT) AS bucket_no,
  CAST(cell_key AS BIGINT) AS cell_key,
  CAST(visits AS BIGINT) AS visits,
  CAST(first_time AS BIGINT) AS first_time,
  CAST(last_time AS BIGINT) AS last_time
FROM novel_cells
ORDER BY channel_id, bucket_no, cell_key
