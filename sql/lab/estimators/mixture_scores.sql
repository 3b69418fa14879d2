-- Mixture scores: the negative log-likelihood, by log-sum-exp over the components: with the strongest one
-- taken out, the sum lies between 1 and their number.
-- Reads:  mixture_densities
-- A row:  one scored vector.
-- Slots:  :log_densities  one column per component, by estimators/mixture_component.sql
--         :shares         the sum of estimators/mixture_share.sql over the components
SELECT channel_id, time, -(peak + LN(:shares)) AS score
FROM (
  SELECT
    channel_id,
    time,
    MAX(log_density) AS peak,
    :log_densities
  FROM mixture_densities
  GROUP BY channel_id, time
) AS gathered
