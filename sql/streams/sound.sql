-- Sound: a reading where it is a number between -1e300 and 1e300; else the sample is missing (method, section 2). For
-- DuckDB, in streams/vectors.sql. Proof: none is needed.
CASE
  WHEN reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN reading.reading
END
