-- Machines: what is known of each machine, counted over its signals: since when it is above, how many of how many watched
-- signals are, which was first, which is strongest. This is the one place that says it.
-- Reads:  signals
-- A row:  one machine. Watched signals are those that something judges. machine_rank is 1 for the one to be looked at
--         first: by its most urgent signal, then by how many are above, then by the strongest.
SELECT
  asset,
  signals,
  watched,
  not_watched,
  above,
  since_tick,
  first_channel,
  strongest_channel,
  strength,
  urgency,
  CAST(
    ROW_NUMBER() OVER (
      ORDER BY urgency DESC, above DESC, CASE WHEN strength IS NULL THEN 1 ELSE 0 END, strength DESC, asset
    ) AS BIGINT
  ) AS machine_rank
FROM (
  SELECT
    member.asset AS asset,
    CAST(COUNT(*) AS BIGINT) AS signals,
    CAST(SUM(CASE WHEN member.judged_by IS NULL THEN 0 ELSE 1 END) AS BIGINT) AS watched,
    CAST(SUM(CASE WHEN member.judged_by IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS not_watched,
    CAST(SUM(member.raised) AS BIGINT) AS above,
    MIN(CASE WHEN member.raised = 1 THEN member.since_tick END) AS since_tick,
    MIN(CASE WHEN member.raised = 1 AND member.place = 1 THEN member.channel END) AS first_channel,
    MIN(CASE WHEN member.raised = 1 AND member.strong_place = 1 THEN member.channel END) AS strongest_channel,
    MAX(CASE WHEN member.raised = 1 THEN member.strength END) AS strength,
    MAX(member.urgency) AS urgency
  FROM (
    SELECT
      asset,
      channel,
      judged_by,
      raised,
      since_tick,
      strength,
      urgency,
      CAST(
        ROW_NUMBER() OVER (
          PARTITION BY asset
          ORDER BY raised DESC, CASE WHEN since_tick IS NULL THEN 1 ELSE 0 END, since_tick, channel
        ) AS BIGINT
      ) AS place,
      CAST(
        ROW_NUMBER() OVER (
          PARTITION BY asset
          ORDER BY raised DESC, CASE WHEN strength IS NULL THEN 1 ELSE 0 END, strength DESC, channel
        ) AS BIGINT
      ) AS strong_place
    FROM (
      SELECT
        asset,
        channel,
        judged_by,
        CASE WHEN is_above = 1 THEN 1 ELSE 0 END AS raised,
        since_tick,
        strength,
        urgency
      FROM signals
    ) AS signal_state
  ) AS member
  GROUP BY member.asset
) AS counted
