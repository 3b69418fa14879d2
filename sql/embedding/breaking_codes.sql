-- Breaking codes: codes, with whether a segment begins with a sample: a step in time larger than max_gap ends one
-- (method, section 1). The first sample that is read begins none: no vector ends before it.
-- Reads:  codes
-- A row:  one sample; breaking = 1 if a segment begins with it.
-- Slots:  :carried  columns that travel with the sample
--         :max_gap  the longest step inside a segment, in the unit of time
SELECT
  channel_id,
  time,
  code,
  CASE
    WHEN time - LAG(time, 1) OVER (PARTITION BY channel_id ORDER BY time) > :max_gap THEN 1
    ELSE 0
  END AS breaking,
  :carried
FROM codes
