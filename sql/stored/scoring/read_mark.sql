-- Read mark: what one reading adds to the sum of what was read, a checksum that all engines add to the same, in any
-- order. The column mixed (stored/scoring/read_mixed.sql; 0 where rows are only counted) is nearly a polynomial of time
-- and code, and codes that change places between neighbours would leave its sum; squared, and reduced by another
-- prime, it is none. No reading adds nothing.
1 + mixed * mixed % 2147483647
