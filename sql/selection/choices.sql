-- Choices: what to take for each channel, and by which rule (method, section 8).
-- Reads:  channels, bounds, delays, cycles, unfoldings, joint
-- A row:  one channel, in order. A window shorter than five cycles is short: recommended_window is then
--         five cycles in whole hundreds. It is at most the longest of which calibration has eight, and
--         NULL where that has fewer than 10 vectors: calibration is too short for any.
-- Slots:  :bins, :window  B and W as they were asked for
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(CASE WHEN delay_choice.hit = 1 THEN delay_choice.samples ELSE 0 END AS BIGINT) AS samples,
  CAST(CASE WHEN delay_choice.hit = 1 THEN delay_choice.usable ELSE 0 END AS BIGINT) AS usable,
  CASE WHEN delay_choice.hit = 1 THEN delay_choice.tau END AS tau,
  CASE WHEN delay_choice.hit = 1 THEN delay_choice.tau_rule ELSE 'none' END AS tau_rule,
  CASE WHEN delay_choice.hit = 1 THEN delay_choice.ami_minimum END AS ami_minimum,
  CASE WHEN delay_choice.hit = 1 THEN delay_choice.acf_1e END AS acf_1e,
  CASE WHEN delay_choice.hit = 1 THEN delay_choice.acf_zero END AS acf_zero,
  CASE WHEN unfolds.hit = 1 THEN unfolds.m_fnn END AS m_fnn,
  CASE WHEN unfolds.hit = 1 THEN unfolds.fnn_status ELSE 'none' END AS fnn_status,
  CASE WHEN unfolds.hit = 1 THEN unfolds.m_cao END AS m_cao,
  CASE WHEN unfolds.hit = 1 THEN unfolds.cao_status ELSE 'none' END AS cao_status,
  CAST(CASE WHEN turning.hit = 1 THEN turning.cycle_length END AS BIGINT) AS cycle_length,
  CASE
    WHEN turning.hit = 1
      THEN CASE
        WHEN 5 * turning.cycle_length <= CAST(:window AS BIGINT) THEN 'enough'
        ELSE 'short'
      END
    ELSE 'no_cycle'
  END AS window_status,
  CAST(
    CASE
      WHEN chosen.hit = 1 AND chosen.longest < 10 AND chosen.longest < CAST(:window AS BIGINT) THEN NULL
      WHEN turning.hit = 1 AND 5 * turning.cycle_length > CAST(:window AS BIGINT)
        THEN CASE
          WHEN chosen.hit = 1 AND turning.five_cycles > chosen.longest THEN chosen.longest
          ELSE turning.five_cycles
        END
      WHEN chosen.hit = 1 AND chosen.longest < CAST(:window AS BIGINT) THEN chosen.longest
      ELSE CAST(:window AS BIGINT)
    END AS BIGINT
  ) AS recommended_window,
  CASE WHEN chosen.hit = 1 THEN chosen.m END AS recommended_m,
  CAST(
    CASE
      WHEN chosen.hit = 1 AND chosen.verdict = 'needs_data' THEN CAST(:bins AS BIGINT)
      WHEN chosen.hit = 1 THEN chosen.finest_bins
    END AS BIGINT
  ) AS recommended_bins,
  CASE
    WHEN scale.calibrated_lo IS NULL THEN 'no_data'
    WHEN scale.calibrated_hi = scale.calibrated_lo THEN 'constant'
    WHEN chosen.hit = 1 THEN chosen.verdict
    ELSE 'no_data'
  END AS verdict,
  CASE WHEN chosen.hit = 1 THEN chosen.floor END AS floor,
  CASE WHEN chosen.hit = 1 THEN chosen.finest_floor END AS recommended_floor,
  CASE WHEN chosen.hit = 1 THEN chosen.vectors_needed END AS vectors_needed
FROM channels AS named
JOIN bounds AS scale ON scale.channel_id = named.channel_id
LEFT JOIN (
  SELECT
    channel_id,
    samples,
    usable,
    tau,
    tau_rule,
    ami_minimum,
    acf_1e,
    acf_zero,
    1 AS hit
  FROM delays
) AS delay_choice ON delay_choice.channel_id = named.channel_id
LEFT JOIN (
  SELECT
    channel_id,
    cycle_length,
    100 * CAST(
      FLOOR(
        (CAST(5 * cycle_length + 99 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(100 AS DOUBLE)
      ) AS BIGINT
    ) AS five_cycles,
    1 AS hit
  FROM cycles
) AS turning ON turning.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, m_fnn, fnn_status, m_cao, cao_status, 1 AS hit
  FROM unfoldings
) AS unfolds ON unfolds.channel_id = named.channel_id
LEFT JOIN (
  SELECT
    channel_id,
    m,
    CAST(
      FLOOR((CAST(vectors AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(8 AS DOUBLE)) AS BIGINT
    ) AS longest,
    verdict,
    finest_bins,
    finest_floor,
    floor,
    vectors_needed,
    1 AS hit
  FROM joint
) AS chosen ON chosen.channel_id = named.channel_id
ORDER BY named.asset, named.channel
