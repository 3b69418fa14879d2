-- Number, in stored order: that of the vector that a sample ends, from 1, where every vector counts. For DuckDB, by
-- streams/vectors.sql, which numbers rows as they come. Proof: that of the vectors.
-- Slots:  :span  (m-1) * tau, the samples before the first vector
position - :span
