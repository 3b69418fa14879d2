-- Read, mixed: an integer for one reading, made of its time and code; what stored/scoring/read_mark.sql is made of.
-- Times are spread, and two products are reduced by different primes, so that no two instants within 10^5 years are
-- alike.
((time % 2147483647) * 1103515245 + CAST(code AS BIGINT) + 1) % 2147483647
* (((time % 2147483629) * 1140671485 + CAST(code AS BIGINT) + 1) % 2147483629) % 2147483587
