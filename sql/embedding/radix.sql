-- Radix: R = bins + 3, the codes that a sample can have (method, section 3), where channels differ in it.
CAST(bins AS BIGINT) + 3
