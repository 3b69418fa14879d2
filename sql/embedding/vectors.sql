-- Vectors: v(t) = [x(t), x(t - tau), ..., x(t - (m - 1) tau)] in codes, as a cell's key (Eq. 1). Delays,
-- position and all that is asked of the samples before are made in one window pass.
-- Reads:  codes
-- A row:  one vector, at the time of its newest sample; cell_key is NULL where a sample is missing;
--         position counts the samples of the channel up to it; context_time is that of the oldest sample of
--         the next vector, from where on a later run must read.
-- Slots:  :delayed     code_1 ... code_(m-1), the delayed codes, and other columns over the same order
--         :context     the time of the oldest sample of the next vector
--         :is_present  all coordinates are there
--         :cell_key    the mixed-radix integer of the coordinates
--         :outside     a coordinate lies outside the calibrated range
--         :carried     columns that travel with the vector
--         :whole       whether the samples before are those of a vector
SELECT
  channel_id,
  time,
  CASE WHEN :is_present THEN :cell_key END AS cell_key,
  CASE WHEN :outside THEN 1 ELSE 0 END AS out_of_range,
  position,
  context_time,
  :carried
FROM (
  SELECT
    channel_id,
    time,
    code AS code_0,
    :delayed,
    :context AS context_time,
    CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) AS position
  FROM codes
) AS embedded
WHERE :whole
