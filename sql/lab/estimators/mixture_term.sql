-- Mixture term: what one coordinate adds to a projection. Repeated by Python and summed.
-- Slots:  :coordinate  x_i
--         :factor      the entry of the factor of the component's precision
:coordinate * :factor
