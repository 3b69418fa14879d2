-- Would not see: what of a frozen sensor, half a stroke and another speed would not lift the indicator above its limit, in
-- words; NULL where nothing is known not to.
-- Slots:  none; over sight
CASE
  WHEN probed.sees_frozen = 0
    THEN CASE
      WHEN probed.sees_half_stroke = 0
        THEN CASE
          WHEN probed.sees_faster = 0 OR probed.sees_slower = 0 THEN 'a frozen sensor, half a stroke, another speed'
          ELSE 'a frozen sensor, half a stroke'
        END
      WHEN probed.sees_faster = 0 OR probed.sees_slower = 0 THEN 'a frozen sensor, another speed'
      ELSE 'a frozen sensor'
    END
  WHEN probed.sees_half_stroke = 0
    THEN CASE
      WHEN probed.sees_faster = 0 OR probed.sees_slower = 0 THEN 'half a stroke, another speed'
      ELSE 'half a stroke'
    END
  WHEN probed.sees_faster = 0 OR probed.sees_slower = 0 THEN 'another speed'
END
