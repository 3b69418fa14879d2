-- Whole: whether the samples up to this one are as many as a vector takes.
-- Slots:  :span  (m-1) * tau, the samples between its oldest and its newest
position > :span
