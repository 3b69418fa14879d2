-- Radix: R = bins + 3, the codes that a sample can have (method, section 3), of a channel of a run.
CAST(member.bins + 3 AS INTEGER)
