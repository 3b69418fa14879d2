-- Label leads: whether a labelled event was raised, and how long before its start. A run of raised values
-- that reaches the start counts from its own start; else the first raised value inside the event counts,
-- and the lead is negative: a delay. Where no value lies before the start, the first one counts as the start.
-- Reads:  timeline
-- A row:  one label of one channel or, with channel NULL, of one machine.
SELECT
  asset,
  channel,
  label_no,
  time AS starts_at,
  CASE WHEN value_next <= ends_at THEN 1 ELSE 0 END AS has_values,
  CASE
    WHEN value_next > ends_at OR value_next IS NULL THEN NULL
    WHEN raised_since > COALESCE(calm_at, raised_since - 1) THEN time - raised_since
    WHEN raised_next <= ends_at AND raised_since IS NULL AND calm_at IS NULL THEN value_next - raised_next
    WHEN raised_next <= ends_at THEN time - raised_next
  END AS lead_time
FROM timeline
WHERE label_no IS NOT NULL
