-- Program problems: what a machine ran since calibration that it holds too little of, or nothing.
-- Reads:  stored_unjudged_program
-- A row:  one program of one machine; affected is the most readings that one of its signals has of it, since and until are
--         integer times. program is NULL for readings of which nothing says what ran.
-- Slots:  :monitor  its name
SELECT
  asset,
  program,
  CAST(COUNT(*) AS BIGINT) AS channels,
  MIN(ran.verdict) AS verdict,
  MAX(ran.readings) AS affected,
  MIN(ran.first_tick) AS since,
  MAX(ran.last_tick) AS until
FROM stored_unjudged_program AS ran
WHERE monitor = :monitor
GROUP BY asset, program
