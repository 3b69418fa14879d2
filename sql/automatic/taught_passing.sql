-- Taught passing: as taught_before, of supports that pass on some grid: no others are probed.
-- Reads:  taught_before, passing
-- A row:  one learner.
SELECT own.channel_id AS channel_id, own.vectors AS vectors, own.vectors_before AS vectors_before
FROM taught_before AS own
JOIN (
  SELECT DISTINCT support_id
  FROM passing
) AS good ON good.support_id = own.support_id
