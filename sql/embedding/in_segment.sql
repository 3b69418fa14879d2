-- In segment: whether the samples of a vector are as many as it takes, in one segment (method, section 1).
-- Slots:  :span  (m-1) * tau, the samples between its oldest and its newest
position > :span AND oldest_time >= segment_from
