-- Squared: one coordinate's share in a squared length. Repeated by Python, once per coordinate, and
-- summed.
-- Slots:  :difference  what is squared
(:difference) * (:difference)
