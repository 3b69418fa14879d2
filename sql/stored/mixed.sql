-- Mixed: two integers as one below p = 2^31 - 1, so that a sum of such is a checksum of a table: of integers
-- that all engines add to the same, in any order.
--   x = ((number mod p) * 31 + count + 1) mod p,  mixed = x^2 mod p
-- Slots:  :number  of any size and sign
--         :count   below 2^62
(
  (((:number % 2147483647) * 31 + :count + 1) % 2147483647)
  * (((:number % 2147483647) * 31 + :count + 1) % 2147483647)
) % 2147483647
