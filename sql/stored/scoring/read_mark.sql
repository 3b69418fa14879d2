-- Read mark: an integer for one reading, made of its time and code, so that the sum over readings is a checksum that
-- all engines add to the same, in any order. Two products are reduced by different primes, so that no two instants
-- within 10^5 years are alike.
CAST(
  (((time % 2147483647) * 31 + CAST(code AS BIGINT) + 1) % 2147483647)
  * (((time % 2147483629) * 37 + CAST(code AS BIGINT) + 1) % 2147483629) % 2147483647 AS BIGINT
)
