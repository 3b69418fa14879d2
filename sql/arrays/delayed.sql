-- Delayed, in an array: the codes of one coordinate, vector by vector. Repeated by Python, once per coordinate. For
-- ClickHouse, where a piece of an array costs less than a window. Proof: that of arrays/vectors.sql.
-- Dialect: clickhouse
-- Slots:  :place  of the first one among the samples that are read
arraySlice(codes, :place, vectors)
