-- Number: the number of a vector where no sample is missing: its position less the samples of the run-up.
-- Slots:  :span  (m-1) * tau, the samples before the first vector
vector.position - :span
