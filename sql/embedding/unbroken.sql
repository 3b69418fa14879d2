-- Unbroken: whether no segment begins with a sample of a vector (method, section 1), none but the oldest. Repeated by
-- Python for each sample after that.
-- Slots:  :breaking  1 if a segment begins with it
:breaking = 0
