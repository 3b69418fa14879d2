-- Delays: tau by rule (method, section 8): the first minimum of mutual information, else the first lag
-- with an autocorrelation below 1/e, else the first with none; rules before the user's first choice are
-- passed over. Where a sample tells nothing of the next one, no delay means anything: none.
-- Reads:  extents, curve, minima
-- A row:  one channel. embedded_tau is what the next steps take, 1 where tau is NULL; memory is the
--         first lag with an autocorrelation below 1/e, else the longest lag.
-- Slots:  :tau         the user's own, NULL if there is none
--         :first_rule  0 first_minimum, 1 acf_1e, 2 acf_zero
SELECT
  channel_id,
  samples,
  usable,
  tau,
  tau_rule,
  ami_minimum,
  acf_1e,
  acf_zero,
  CASE WHEN tau IS NULL THEN CAST(1 AS BIGINT) ELSE tau END AS embedded_tau,
  CASE WHEN acf_1e IS NULL THEN longest_lag ELSE acf_1e END AS memory
FROM (
  SELECT
    channel_id,
    samples,
    usable,
    longest_lag,
    ami_minimum,
    acf_1e,
    acf_zero,
    tau_rule,
    CASE tau_rule
      WHEN 'given' THEN CAST(:tau AS BIGINT)
      WHEN 'first_minimum' THEN ami_minimum
      WHEN 'acf_1e' THEN acf_1e
      WHEN 'acf_zero' THEN acf_zero
    END AS tau
  FROM (
    SELECT
      channel_id,
      samples,
      usable,
      longest_lag,
      ami_minimum,
      acf_1e,
      acf_zero,
      CASE
        WHEN CAST(:tau AS BIGINT) >= 1 THEN 'given'
        WHEN informative = 0 THEN 'none'
        WHEN CAST(:first_rule AS INTEGER) <= 0 AND ami_minimum IS NOT NULL THEN 'first_minimum'
        WHEN CAST(:first_rule AS INTEGER) <= 1 AND acf_1e IS NOT NULL THEN 'acf_1e'
        WHEN acf_zero IS NOT NULL THEN 'acf_zero'
        ELSE 'none'
      END AS tau_rule
    FROM (
      SELECT
        extent.channel_id AS channel_id,
        extent.samples AS samples,
        extent.usable AS usable,
        extent.longest_lag AS longest_lag,
        CAST(CASE WHEN lowest.hit = 1 THEN lowest.tau END AS BIGINT) AS ami_minimum,
        CAST(CASE WHEN fallen.hit = 1 THEN fallen.acf_1e END AS BIGINT) AS acf_1e,
        CAST(CASE WHEN fallen.hit = 1 THEN fallen.acf_zero END AS BIGINT) AS acf_zero,
        CASE WHEN fallen.hit = 1 THEN fallen.informative ELSE 0 END AS informative
      FROM extents AS extent
      LEFT JOIN (
        SELECT channel_id, MIN(bottom.tau) AS tau, 1 AS hit
        FROM minima AS bottom
        GROUP BY channel_id
      ) AS lowest ON lowest.channel_id = extent.channel_id
      LEFT JOIN (
        SELECT
          channel_id,
          MIN(
            CASE
              WHEN delay > 0 AND acf < CAST(3.678794411714423e-1 AS DOUBLE) THEN delay
            END
          ) AS acf_1e,
          MIN(CASE WHEN delay > 0 AND acf <= CAST(0 AS DOUBLE) THEN delay END) AS acf_zero,
          MAX(CASE WHEN delay = 1 THEN falling.informative ELSE 0 END) AS informative,
          1 AS hit
        FROM curve AS falling
        GROUP BY channel_id
      ) AS fallen ON fallen.channel_id = extent.channel_id
    ) AS estimate
  ) AS ruled
) AS resolved
