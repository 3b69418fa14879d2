-- Unbroken: whether the samples of a vector are as many as it takes, in one segment (method, section 1): none but the
-- oldest begins one.
-- Slots:  :span  (m-1) * tau, the samples between its oldest and its newest
position > :span AND breaks = 0
