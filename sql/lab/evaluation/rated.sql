-- Rated: the series that the fleet is judged by. Stratum 0 holds those that should show a trend: the
-- failed channel of each failed asset or, where no outcome is known, every channel. Stratum 1 holds the
-- channels of healthy assets.
-- Reads:  series_metrics, members
-- A row:  one series.
SELECT
  measured.series_id AS series_id,
  member.asset_no AS asset_no,
  member.stratum AS stratum,
  member.has_outcome AS has_outcome,
  measured.mon AS mon,
  measured.corr_size AS corr_size,
  measured.rob AS rob,
  measured.last_hi AS last_hi,
  measured.amplitude AS amplitude,
  measured.hi_sd AS hi_sd
FROM series_metrics AS measured
JOIN members AS member ON member.series_id = measured.series_id
WHERE member.stratum >= 0
