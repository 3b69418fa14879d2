-- Mixture component: the log density of one component, out of the rows of a vector. NULL where the mixture
-- has fewer components. Repeated by Python, once per component.
-- Slots:  :component  its number
MAX(CASE WHEN component = :component THEN log_density END)
